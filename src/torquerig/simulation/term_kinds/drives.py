"""Motors under their controllers, and how each sees its speed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import pi
from typing import NamedTuple

from torquerig.rig.terms import Drive, Term
from torquerig.simulation.arrays import Floats, Rows, Starts
from torquerig.simulation.term_kinds.kind import UNFILLED, Lowering, TermKind, floats, phased, sounding, whole
from torquerig.simulation.waves import WaveTable


class Drives(NamedTuple):
    """Motors; ``reference`` holds the set-point of the speed at every sample, ``demand`` the torque beside the PI."""

    on: Rows
    against: Rows
    kp: Floats
    ki: Floats
    limit: Floats
    inverse_lag: Floats
    r_first: Starts
    r_slot: Rows
    r_c: Floats
    r_s: Floats
    breakdown: Floats  # slip speed of an induction machine's breakdown, 0 for a controlled drive
    reference: Floats  # (drives, settling + samples + 1)
    demand: Floats  # (drives, settling + samples + 1)


class Sensings(NamedTuple):
    """What each drive sees of its speed; the error's waves are made where they are needed, once a sample."""

    ideal: Rows  # 1 where it sees the true speed
    step: Floats  # (drives,) [rad] of a count, 0: continuous
    filter_time: Floats
    first: Starts
    order: Floats
    c: Floats
    s: Floats


class DriveKind(TermKind[Drive, Drives]):
    """Motors; each row has a state of its own in the kernel, the torque behind the current lag."""

    field = "drives"
    made_from = (Drive,)
    deciding = ("breakdown",)

    def chosen(self, terms: Sequence[Term]) -> tuple[Drive, ...]:
        """Return the drives with the ripple that has a size."""
        return tuple(sounding(drive, "ripple") for drive in super().chosen(terms))

    def orders(self, terms: Sequence[Drive]) -> Iterator[tuple[str, float]]:
        """Yield the ripple."""
        yield from ((drive.on, wave.order) for drive in terms for wave in drive.ripple)

    def rows(self, terms: Sequence[Drive], to: Lowering) -> Drives:
        """Return the drives, their set-points and demands still empty."""
        ripple = phased([(t.name, to.number[t.on], t.ripple) for t in terms], to.table, to.seed)
        return Drives(
            on=whole(to.number[t.on] for t in terms),
            against=whole(to.number[t.against] for t in terms),
            kp=floats(t.kp for t in terms),
            ki=floats(t.ki for t in terms),
            limit=floats(t.torque_limit for t in terms),
            inverse_lag=floats(1 / t.lag for t in terms),
            r_first=ripple.first,
            r_slot=ripple.slot,
            r_c=ripple.c,
            r_s=ripple.s,
            breakdown=floats(t.breakdown for t in terms),
            reference=UNFILLED,
            demand=UNFILLED,
        )

    def refused(self, terms: Sequence[Drive]) -> Iterator[tuple[str, str]]:
        """Yield what is demanded beside the speed, an encoder, and a torque over the slip."""
        for drive in terms:
            if not drive.holds_speed or drive.torque or drive.demand is not None:
                yield drive.name, "a torque that is demanded"
            if not drive.sensing.ideal:
                yield drive.name, "a speed seen through an encoder"
            if drive.breakdown:
                yield drive.name, "a torque over the slip, which is no straight line,"

    def left_out(self, terms: Sequence[Drive], rows: Drives) -> Iterator[str]:
        """Yield the ripple's share in changes of the torque, the encoder, the limit, and the bend over the slip."""
        if rows.r_slot.size:
            yield "the motor's ripple in proportion to changes of its torque (it has that of the steady torque)"
        if any(drive.sensing.counts or drive.sensing.error for drive in terms):
            yield "the counts and the error of the encoder that the speed loop sees its speed by"
        if terms:
            yield "the torque limit of the motor"
        if any(drive.breakdown for drive in terms):
            yield "the bend of the motor's torque over its slip, taken as straight through no load"


class SensingKind(TermKind[Drive, Sensings]):
    """How the drives see their speeds."""

    field = "sensings"
    made_from = (Drive,)
    deciding = ("step", "filter_time")

    def rows(self, terms: Sequence[Drive], to: Lowering) -> Sensings:
        """Return what the drives see of their speeds."""
        senses = [(t.name, to.number[t.on], t.sensing.error) for t in terms]
        waves = phased(senses, WaveTable.of((node, w.order) for _, node, ws in senses for w in ws), to.seed)
        return Sensings(
            ideal=whole(t.sensing.ideal for t in terms),
            step=floats(2 * pi / t.sensing.counts if t.sensing.counts else 0.0 for t in terms),
            filter_time=floats(t.sensing.filter_time for t in terms),
            first=waves.first,
            order=waves.order,
            c=waves.c,
            s=waves.s,
        )


DRIVES, SENSINGS = DriveKind(), SensingKind()
