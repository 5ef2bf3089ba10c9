"""The torques of one evaluation: torques of springs, frictions, loads and drives on the nodes."""

from __future__ import annotations

from numba import njit

from torquerig.simulation.kernel.choice import any_of, where
from torquerig.simulation.kernel.contact import touch
from torquerig.simulation.kernel.direction import direction
from torquerig.simulation.kernel.elementary import exponential
from torquerig.simulation.kernel.fast import FAST
from torquerig.simulation.kernel.ladder import climb
from torquerig.simulation.kernel.rare import add_rare, vary


@njit(fastmath=FAST, inline="always")
def forces(theta, omega, tau, load_now, terms, cosine, sine, spring_torque, contact, opposing, torque,
           rare, stiffness, damping, twisted, twisting, bristle, bristle_slope, fastest):  # fmt: skip
    """Fill ``torque`` (per node) and the by-products of one evaluation.

    ``stiffness`` and ``damping`` are those of the springs now; ``rare`` says whether there is a term of ``rare.py``.
    """
    waves, springs, harmonics, frictions = terms.waves, terms.springs, terms.harmonics, terms.frictions
    loads, blades, drives = terms.loads, terms.blades, terms.drives
    for i in range(torque.size):
        torque[i], opposing[i] = 0.0, 0.0
    climb(waves, theta, cosine, sine)
    if rare:
        vary(terms.varied, springs, cosine, sine, stiffness, damping)
    for i in range(harmonics.on.size):
        value = 0.0
        for j in range(harmonics.first[i], harmonics.first[i + 1]):
            slot = harmonics.slot[j]
            value += harmonics.c[j] * cosine[slot] - harmonics.s[j] * sine[slot]
        torque[harmonics.on[i]] += value
        torque[harmonics.against[i]] -= value
    for i in range(springs.a.size):
        a, b, r = springs.a[i], springs.b[i], springs.inverse_ratio[i]
        twist = theta[a] * r - theta[b] - springs.rest[i]
        lean = 1.0  # 1 - e': what the kinematic error makes of the lever on b
        for j in range(springs.e_first[i], springs.e_first[i + 1]):
            slot = springs.e_slot[j]
            twist += springs.e_cos[j] * cosine[slot] - springs.e_sin[j] * sine[slot]
            lean += springs.e_order[j] * (springs.e_cos[j] * sine[slot] + springs.e_sin[j] * cosine[slot])
        rate = omega[a] * r - omega[b] * lean
        twisted[i], twisting[i] = twist, rate
        half = springs.half_gap[i]
        if any_of(half > 0.0):
            value, contact[i] = touch(twist, rate, half, stiffness[i], damping[i])
        else:
            value = stiffness[i] * twist + damping[i] * rate
        spring_torque[i] = value
        torque[b] += value * lean
        back = value * r
        if any_of((springs.loss_forward[i] != 0.0) | (springs.loss_backward[i] != 0.0)):
            flow = direction(omega[a] * r, springs.inverse_smoothing[i])
            flow = where(value > 0.0, flow, -flow)
            back *= 1.0 + where(flow > 0.0, springs.loss_forward[i], springs.loss_backward[i]) * flow
        torque[a] -= back
    for i in range(frictions.on.size):
        speed = omega[frictions.on[i]] - omega[frictions.against[i]]
        value = frictions.viscous[i] * speed + frictions.quadratic[i] * speed * abs(speed)
        forward = speed > 0.0
        value += where(forward, 0.0, frictions.backward_extra[i]) * speed
        grip = where(forward, frictions.coulomb[i, 1], frictions.coulomb[i, 0])
        excess = where(forward, frictions.excess[i, 1], frictions.excess[i, 0])
        scaled = speed * frictions.inverse_stribeck[i]
        slow = (abs(scaled) < 6.0) & (excess != 0.0)
        if any_of(slow):
            grip += where(slow, excess * exponential(-scaled * scaled), 0.0)
        if any_of(grip != 0.0):
            value += grip * direction(speed, frictions.inverse_smoothing[i])
        torque[frictions.on[i]] -= value
        torque[frictions.against[i]] += value
        opposing[frictions.on[i]] += value
    for i in range(loads.on.size):
        on = loads.on[i]
        if any_of(loads.inverse_smoothing[i] == 0.0):
            torque[on] += load_now[i]
            continue
        value = load_now[i] * direction(omega[on], loads.inverse_smoothing[i])
        torque[on] -= value
        opposing[on] += value
    for i in range(blades.on.size):
        on, slot = blades.on[i], blades.slot[i]
        wave = blades.c[i] * cosine[slot] - blades.s[i] * sine[slot]
        if any_of(wave > 0.0):
            wave = where(wave > 0.0, wave, 0.0)
            one_way = blades.inverse_smoothing[i] == 0.0
            way = where(one_way, 1.0, direction(omega[on], blades.inverse_smoothing[i]))
            value = blades.amplitude[i] * wave * wave * way
            torque[on] -= value
            opposing[on] += where(one_way, 0.0, value)
    for i in range(drives.on.size):
        factor = 1.0
        for j in range(drives.r_first[i], drives.r_first[i + 1]):
            slot = drives.r_slot[j]
            factor += drives.r_c[j] * cosine[slot] - drives.r_s[j] * sine[slot]
        value = tau[i] * factor
        torque[drives.on[i]] += value
        torque[drives.against[i]] -= value
    if rare:
        add_rare(
            terms, theta, omega, cosine, sine, twisted, spring_torque, bristle, bristle_slope, fastest, torque, opposing
        )
