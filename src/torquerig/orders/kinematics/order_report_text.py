"""The order report as text: rows of its table, and sentences on cogging, coincidences and a better speed."""

from __future__ import annotations

from math import pi

from torquerig.orders.kinematics.coincidences import EqualOrder, OnMains
from torquerig.orders.kinematics.kinematic_lines import KinematicLine
from torquerig.orders.kinematics.order_report import OrdersReport

ORDERS_HEADER = ("Hz", "motor order", "output order", "family", "cause", "source")


def orders_rows(report: OrdersReport) -> tuple[tuple[str, ...], ...]:
    """Return one row of texts per line, under ``ORDERS_HEADER``, by rising frequency."""
    return tuple(
        (
            f"{line.frequency(report.motor_speed):.2f}",
            f"{line.motor_order:.6g}",
            f"{line.output_order:.6g}",
            name_of(line) + ", cancelled" * line.cancelled,
            line.cause,
            line.source,
        )
        for line in report.lines
    )


def orders_sentences(report: OrdersReport) -> tuple[str, ...]:
    """Return the sentences below the table: cogging, planets, mains, equal orders, better speed, missing data."""
    left_out = tuple(f"No {family.replace('_', ' ')} lines: {reason}." for family, reason in report.left_out.items())
    return (
        *cogging_sentence(report),
        *cancelled_sentence(report),
        *mains_sentences(report),
        *equal_order_sentences(report),
        better_speed_sentence(report),
        *left_out,
    )


def name_of(line: KinematicLine) -> str:
    """Return a line's short name: ``gear mesh x2``, without number for the fundamental."""
    return line.label if line.harmonic == 1 else f"{line.label} x{line.harmonic}"


def cogging_sentence(report: OrdersReport) -> tuple[str, ...]:
    """Return the sentence on the order of cogging; nothing where poles or slots are unknown."""
    per_pole, cogging = report.fundamental("cogging_per_pole"), report.fundamental("cogging")
    if per_pole is None or cogging is None or report.kinematics.pole_pairs is None:
        return ()
    magnets = 2 * report.kinematics.pole_pairs
    sentence = (
        f"Cogging is at {cogging.frequency(report.motor_speed):.2f} Hz: motor order {cogging.motor_order:g}, the least "
        f"common multiple of {report.kinematics.slots} slots and {magnets} magnets. Motor order "
        f"{per_pole.motor_order:g} ({per_pole.frequency(report.motor_speed):.2f} Hz) is the same count per magnet; no "
        "cogging torque has this order."
    )
    return (sentence,)


def cancelled_sentence(report: OrdersReport) -> tuple[str, ...]:
    """Return the sentence on the mesh lines that equal planets cancel; empty where there are none."""
    gone = [name_of(line) for line in report.lines if line.cancelled]
    if not gone:
        return ()
    sentence = (
        f"Equal planets cancel {', '.join(gone)} in the torque (they act as a lateral force on the gearbox). With "
        "unequal planets a part of them remains, with side lines."
    )
    return (sentence,)


def mains_sentences(report: OrdersReport) -> tuple[str, ...]:
    """Return one sentence per mains multiple with a line on it."""
    mains = report.coincidences.mains
    by_multiple: dict[int, list[OnMains]] = {}
    for hit in report.coincidences.on_mains:
        by_multiple.setdefault(hit.multiple, []).append(hit)
    sentences = []
    for multiple, hits in by_multiple.items():
        names = " and ".join(dict.fromkeys(name_of(hit.line) for hit in hits))
        offset = max(abs(hit.offset) for hit in hits)
        exactly = "exactly" if offset < 0.005 else f"within {offset:.2f} Hz"
        sentences.append(f"{multiple * mains:g} Hz is {multiple} x mains and, {exactly}, {names}.")
    return tuple(sentences)


def equal_order_sentences(report: OrdersReport) -> tuple[str, ...]:
    """Return one sentence per order that several families share."""
    return tuple(_equal(group) for group in report.coincidences.equal_orders)


def better_speed_sentence(report: OrdersReport) -> str:
    """Return the sentence on the test speed at which the lines keep a distance from the mains multiples."""
    better, mains = report.better, report.coincidences.mains
    rpm, given = better.motor_speed * 30 / pi, abs(report.motor_speed) * 30 / pi
    shared = " Equal orders coincide at any speed." if report.coincidences.equal_orders else ""
    if abs(rpm - given) < 1e-6 and not better.crowded:
        return (
            f"At {given:g} rpm every line is {better.clearance:.2f} Hz or more from multiples of {mains:g} Hz.{shared}"
        )
    if not better.crowded:
        return (
            f"A better test speed is {rpm:g} rpm, the nearest at which every line is {better.clearance:.2f} Hz or more "
            f"from multiples of {mains:g} Hz.{shared}"
        )
    crowded = ", ".join(name_of(line) for line in better.crowded)
    return (
        f"No speed in the searched range keeps every line {better.wanted:g} Hz from multiples of {mains:g} Hz. The "
        f"best is {rpm:g} rpm, where {crowded} {'is' if len(better.crowded) == 1 else 'are'} still nearer.{shared}"
    )


def _equal(group: EqualOrder) -> str:
    names = " and ".join(dict.fromkeys(name_of(line) for line in group.lines))
    return f"{group.frequency:.2f} Hz is {names}: equal orders, which no speed separates."
