"""The rig through time by Runge-Kutta 4 with fixed substeps.

Between two kinks of a contact law the right-hand side is smooth and the method has its fourth order; a step that would
cross a kink (flanks meet or part, damping reaches the spring's torque) is shortened until it ends just behind it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numba import njit

from torquerig.simulation.arrays import Floats, Outputs
from torquerig.simulation.kernel.choice import any_of, where
from torquerig.simulation.kernel.contact import narrow
from torquerig.simulation.kernel.control import control
from torquerig.simulation.kernel.fast import FAST, UNCOUNTED
from torquerig.simulation.kernel.forces import forces
from torquerig.simulation.kernel.imposed import free, impose
from torquerig.simulation.kernel.keep import keep
from torquerig.simulation.kernel.rare import has_rare
from torquerig.simulation.kernel.sources import sources_key
from torquerig.simulation.kernel.work import Work, work_for
from torquerig.simulation.term_kinds import Terms

LOCATED = 2.0**-22  # [1] share of a substep within which a kink is located
PATIENT = 16  # [1] passes of a step after which the search halves what is left, whatever it expects


def _built(key: int) -> Callable[..., Any]:
    """Return the compiled loop; ``key`` is closed over so that the cache on disk is keyed by it."""

    @njit(cache=True, nogil=True, fastmath=FAST, **UNCOUNTED)
    def advance(theta, omega, terms, outputs, rate, settling, substeps, kept, work, first, last, given):
        # loads, set-points and demands are given from the sample `given` on
        drives, loads, imposed, bristles = terms.drives, terms.loads, terms.imposed, terms.bristles
        moving, n_drives, n_bristles = theta.size - 1, drives.on.size, bristles.on.size  # moving: all but the ground
        cosine, sine, load_now, inverse_inertia = work.cosine, work.sine, work.load_now, work.inverse_inertia
        spring_torque, contact, contact_before = work.spring_torque, work.contact, work.contact_before
        twisted_before, twisting_before = work.twisted_before, work.twisting_before
        stiffness, damping, gaps = work.stiffness, work.damping, work.gaps
        twisted, twisting = work.twisted, work.twisting
        opposing, torque, torque_before = work.opposing, work.torque, work.torque_before
        integral, command, seen_angle, seen_speed = work.integral, work.command, work.seen_angle, work.seen_speed
        theta_k, omega_k, theta_sum, omega_sum = work.theta_k, work.omega_k, work.theta_sum, work.omega_sum
        tau, tau_k, tau_sum = work.tau, work.tau_k, work.tau_sum
        bend, bend_k, bend_sum = work.bend, work.bend_k, work.bend_sum
        bend_slope, bend_before = work.bend_slope, work.bend_before
        period = 1.0 / rate
        h = period / substeps
        fastest = 1.0 / h  # [1/s] at which a bristle may follow
        near = LOCATED * h
        # terms that most rigs lack: one test skips them all; a key is never below 0
        rare = has_rare(terms) or key < 0
        for sample in range(first, last):
            if rare:
                free(imposed, sample, inverse_inertia)
                impose(imposed, sample, 0.0, period, theta, omega)
            now = sample - given
            control(
                drives, terms.sensings, sample, now, theta, omega, period, integral, command, seen_angle, seen_speed
            )
            # the very first pass has no length: it makes the forces at the start; later ones are there
            for step in range(-1 if sample == 0 else 0, substeps):
                if step == 0 and sample >= settling:
                    keep(
                        kept,
                        sample - settling,
                        outputs,
                        theta,
                        omega,
                        tau,
                        spring_torque,
                        opposing,
                        torque_before,
                        imposed,
                        sample,
                        period,
                    )
                start, remaining = max(0, step) * h, 0.0 if step < 0 else h
                low, high, length = 0.0, remaining, remaining
                searching, was_behind, was_before, first_pass, tries = False, False, False, step < 0, 0
                while True:
                    for i in range(moving):
                        slope = torque_before[i] * inverse_inertia[i]
                        theta_sum[i], omega_sum[i] = length / 6.0 * omega[i], length / 6.0 * slope
                        theta_k[i] = theta[i] + 0.5 * length * omega[i]
                        omega_k[i] = omega[i] + 0.5 * length * slope
                    for i in range(n_drives):
                        slope = (command[i] - tau[i]) * drives.inverse_lag[i]
                        tau_sum[i], tau_k[i] = length / 6.0 * slope, tau[i] + 0.5 * length * slope
                    if rare:
                        for i in range(n_bristles):
                            bend_sum[i] = length / 6.0 * bend_before[i]
                            bend_k[i] = bend[i] + 0.5 * length * bend_before[i]
                    for stage in range(3 if step < 0 else 0, 4):
                        ahead = 0.5 * length if stage < 2 else length
                        if stage == 3:
                            for i in range(moving):
                                theta_k[i], omega_k[i] = theta[i] + theta_sum[i], omega[i] + omega_sum[i]
                            for i in range(n_drives):
                                tau_k[i] = tau[i] + tau_sum[i]
                            if rare:
                                for i in range(n_bristles):
                                    bend_k[i] = bend[i] + bend_sum[i]
                        part = (start + ahead) * rate
                        for i in range(loads.on.size):
                            u = loads.samples[i, now]
                            load_now[i] = u + (loads.samples[i, now + 1] - u) * part
                        if rare:
                            impose(imposed, sample, part, period, theta_k, omega_k)
                        forces(
                            theta_k, omega_k, tau_k, load_now, terms, cosine, sine, spring_torque, contact,
                            opposing, torque, rare, stiffness, damping, twisted, twisting, bend_k, bend_slope, fastest,
                        )  # fmt: skip
                        if stage == 3:
                            break
                        weight = length / 6.0 if stage == 2 else length / 3.0
                        ahead = 0.5 * length if stage == 0 else length
                        for i in range(moving):
                            slope = torque[i] * inverse_inertia[i]
                            theta_sum[i] += weight * omega_k[i]
                            omega_sum[i] += weight * slope
                            theta_k[i] = theta[i] + ahead * omega_k[i]
                            omega_k[i] = omega[i] + ahead * slope
                        for i in range(n_drives):
                            slope = (command[i] - tau_k[i]) * drives.inverse_lag[i]
                            tau_sum[i] += weight * slope
                            tau_k[i] = tau[i] + ahead * slope
                        if rare:
                            for i in range(n_bristles):
                                bend_sum[i] += weight * bend_slope[i]
                                bend_k[i] = bend[i] + ahead * bend_slope[i]
                    kinked = False
                    for g in range(gaps.size):
                        gap = gaps[g]
                        kinked = kinked | (contact[gap] != contact_before[gap])
                    taken, late = (kinked | searching) ^ True, 0.5
                    if first_pass:
                        taken = True
                    elif any_of(kinked | searching):
                        if sample >= settling:
                            work.parted[0] = where(kinked, 1.0, work.parted[0])
                        late = narrow(
                            terms.springs, stiffness, damping, work, kinked, searching, was_behind & kinked,
                            was_before & (kinked ^ True),
                        )  # fmt: skip
                        taken = taken | (kinked & ((late * (length - low) <= near) | (length - low <= near)))
                    if any_of(taken):
                        for i in range(moving):
                            theta[i] = where(taken, theta_k[i], theta[i])
                            omega[i] = where(taken, omega_k[i], omega[i])
                            torque_before[i] = where(taken, torque[i], torque_before[i])
                        for i in range(n_drives):
                            tau[i] = where(taken, tau_k[i], tau[i])
                        if rare:
                            for i in range(n_bristles):
                                bend[i] = where(taken, bend_k[i], bend[i])
                                bend_before[i] = where(taken, bend_slope[i], bend_before[i])
                        for g in range(gaps.size):
                            gap = gaps[g]
                            contact_before[gap] = where(taken, contact[gap], contact_before[gap])
                            twisted_before[gap] = where(taken, twisted[gap], twisted_before[gap])
                            twisting_before[gap] = where(taken, twisting[gap], twisting_before[gap])
                        start = where(taken, start + length, start)
                        remaining = where(taken, remaining - length, remaining)
                    unfinished = remaining > near
                    if not any_of(unfinished):
                        break
                    low = where(taken, 0.0, where(kinked, low, length))
                    high = where(taken, remaining, where(kinked, length, high))
                    searching, tries = taken ^ True, tries + 1
                    was_behind, was_before = searching & kinked, searching & (kinked ^ True)
                    # just behind the change, if the estimate is right; in between in any case
                    between = high - late * (high - low) + 0.5 * near
                    if tries > PATIENT:
                        between = 0.5 * (low + high)
                    length = where(
                        taken | (high - low <= near), high, where(between < high, between, 0.5 * (low + high))
                    )
                    length = where(unfinished, length, 0.0)
            for i in range(moving):
                if any_of((abs(omega[i]) < np.inf) ^ True):
                    return sample, i
        return -1, -1

    return advance


advance = _built(sources_key())


def integrate(
    theta: Floats,
    omega: Floats,
    terms: Terms,
    outputs: Outputs,
    rate: float,
    settling: int,
    substeps: int,
    kept: Floats,
) -> tuple[int, int]:
    """Step the rig through ``settling`` samples that are not kept and ``kept.shape[1]`` that are.

    Parameters
    ----------
    theta, omega : ndarray, shape (nodes + 1,)
        Start angles [rad] and speeds [rad/s]; changed in place to the end state; the ground is last.
    terms : Terms
    rate : float
        Samples and control steps per second [Hz].
    kept : ndarray, shape (outputs, samples)
        Filled with the outputs at the instant of each sample.

    Returns
    -------
    failed_sample, failed_node : int
        -1, -1 when the run went through; else where a speed ceased to be finite (sample counted from the start of
        settling).
    """
    whole = slice(0, settling + kept.shape[1])
    return integrate_part(theta, omega, work_for(terms), terms, outputs, rate, settling, substeps, kept, whole)


def integrate_part(
    theta: Floats,
    omega: Floats,
    work: Work,
    terms: Terms,
    outputs: Outputs,
    rate: float,
    settling: int,
    substeps: int,
    kept: Floats,
    part: slice,
) -> tuple[int, int]:
    """Step through the samples of ``part`` alone, from the state that the samples before it left.

    Several parts one after the other give the bits of ``integrate``.

    Parameters
    ----------
    theta, omega, work
        The state, changed in place; from ``work_for`` at the start.
    kept : ndarray, shape (outputs, samples)
        Its first column is the sample ``settling``.
    """
    failed: tuple[int, int] = advance(
        theta, omega, terms, outputs, rate, settling, substeps, kept[np.newaxis], work, part.start, part.stop, 0
    )
    return failed
