"""A motor's document with the figures of ``as_printed`` converted to the fields of the entry."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any

from torquerig.catalog.derived_keys import with_derived_keys
from torquerig.catalog.printed.converted import MARK, Converted
from torquerig.catalog.printed.emf import NAMES, torque_constant
from torquerig.catalog.printed.figure import Figure
from torquerig.catalog.printed.friction import current_range, friction
from torquerig.catalog.printed.phase import UNITS, inductance_from_time_constant, phase_value
from torquerig.catalog.printed.ratings import (
    continuous,
    duty_contradiction,
    inertia_from_flywheel_effect,
    torque_from_power,
)
from torquerig.catalog.printed.shares import share_of_torque
from torquerig.catalog.printed.sheet import MotorSheet
from torquerig.document import Document
from torquerig.errors import InputError, UnitError
from torquerig.parameter import Parameter
from torquerig.units import written_quantity

OF_MAGNETS = ("voltage_constant", "speed_constant", "torque_constant", "no_load_current", "cogging")


@dataclass(frozen=True)
class _Sheet:
    """The document, its sheet, and the plain values of the entry as far as they can be read."""

    document: Document
    sheet: MotorSheet

    @property
    def six_step(self) -> bool:
        return bool(self.document.data.get("kind") == "bldc")

    def stated(self, field: str, unit: str) -> tuple[float, float] | None:
        """Return the range [SI] of a field that the entry states itself; None where it does not."""
        try:
            estimate = Parameter(unit, field).read_estimate(self.document.data[field])
        except (KeyError, TypeError, ValueError, UnitError):
            return None  # a wrong value is refused with its line when the entry is validated
        return None if estimate.unknown else estimate.bounds

    def refuse(self, key: str, problem: str) -> InputError:
        return InputError(f"{self.document.place(('as_printed', key))}: {problem}")


def converted(document: Document, sheet: MotorSheet) -> Document:
    """Return the document with every figure of ``sheet`` as a field of the entry.

    Raises
    ------
    InputError
        With file, line and key: where a figure has an unsuitable unit, contradicts another one, needs one that is
        missing, or the entry states the same value itself.
    """
    made = _Sheet(document, sheet)
    data = dict(document.data)
    for key, figure in sheet.figures().items():
        if document.data.get("kind") == "induction" and key in OF_MAGNETS:
            raise made.refuse(key, "an induction motor has no magnets, so this does not follow; remove it")
        if figure.duty[0] != "S1" and key not in ("rated_torque", "rated_power", "intermittent_torque"):
            raise made.refuse(key, f"{figure.text!r} has a duty, which only torque and power have; remove it")
    origins: dict[tuple[str, ...], tuple[str | int, ...]] = {}
    for one in _values(made):
        _put(made, data, one)
        origins[tuple(one.field.split("."))] = ("as_printed", one.key)
    return with_derived_keys(document, data, origins=origins)


def _values(made: _Sheet) -> Iterator[Converted]:
    sheet = made.sheet
    torque = _rated_torque(made)
    if torque is not None:
        yield torque
    if sheet.rated_power is not None:
        yield _read(made, "rated_power", _rated_power)
    rated = (torque.low, torque.high) if torque is not None else made.stated("rated_torque", "N*m")
    if sheet.flywheel_effect is not None:
        yield _read(made, "flywheel_effect", inertia_from_flywheel_effect)
    constant = _torque_constant(made)
    if constant is not None and "torque_constant" not in made.document.data:
        yield constant
    if sheet.rated_current is not None:
        yield _read(made, "rated_current", lambda figure: _rated_current(figure, six_step=made.six_step))
    yield from _windings(made)
    yield from _frictions(made, constant)
    for key, field in (("cogging", "cogging_native"), ("torque_ripple", "six_pulse_ripple")):
        if getattr(sheet, key) is not None:
            share = _read(made, key, lambda figure, key=key, field=field: share_of_torque(
                key, figure, f"ripple.{field}", rated_torque=rated))  # fmt: skip
            yield share
            if key == "cogging" and "cogging_tolerance" not in (made.document.data.get("ripple") or {}):
                words = f"{share.words}; the sheet prints the sum of all lines, so each of these is at most that"
                yield Converted("ripple.cogging_tolerance", 0.0, share.high, "1", words, key)


def _read(made: _Sheet, key: str, conversion: Any) -> Converted:
    try:
        found: Converted = conversion(getattr(made.sheet, key))
    except UnitError as error:
        raise made.refuse(key, str(error)) from None
    return found


def _rated_torque(made: _Sheet) -> Converted | None:
    sheet, stated = made.sheet, made.stated("rated_torque", "N*m")
    if sheet.rated_torque is not None:
        found = _read(made, "rated_torque", lambda figure: _torque("rated_torque", figure))
        _check_intermittent(made, (found.low, found.high))
        return found
    if stated is not None or "rated_torque" in made.document.data:
        _check_intermittent(made, stated)
        return None
    if sheet.intermittent_torque is not None:
        return _read(made, "intermittent_torque", lambda figure: _intermittent(made, figure))
    speed = made.stated("rated_speed", "rpm")
    if sheet.rated_power is None or speed is None:
        return None
    return _read(made, "rated_power", lambda figure: continuous(
        "rated_torque", "N*m", figure, torque_from_power(figure, speed), key="rated_power",
        said=f"rated power {figure.text} over the rated speed",
    ))  # fmt: skip


def _torque(key: str, figure: Figure) -> Converted:
    said = f"{key.replace('_', ' ')} {figure.text}"
    return continuous("rated_torque", "N*m", figure, figure.quantity("N*m"), key=key, said=said)


def _intermittent(made: _Sheet, figure: Figure) -> Converted:
    if figure.duty[0] != "S3":
        raise made.refuse("intermittent_torque", f"{figure.text!r} needs its duty, such as 'S3 40 %'")
    return _torque("intermittent_torque", figure)


def _check_intermittent(made: _Sheet, continuous: tuple[float, float] | None) -> None:
    figure = made.sheet.intermittent_torque
    if figure is None or continuous is None:
        return
    _read(made, "intermittent_torque", lambda figure: _intermittent(made, figure))
    problem = duty_contradiction(figure, continuous)
    if problem:
        raise made.refuse("intermittent_torque", problem)


def _torque_constant(made: _Sheet) -> Converted | None:
    """Return the torque constant from Kt, Ke and kV together, and from what the entry states itself."""
    wound = frozenset({made.sheet.winding}) if made.sheet.winding else frozenset()
    printed = {key: figure for key in NAMES if (figure := getattr(made.sheet, key)) is not None}
    figures = {key: replace(figure, words=figure.words | wound) for key, figure in printed.items()}
    own = made.stated("torque_constant", "N*m/Arms")
    if own is not None and "torque_constant" in figures:
        raise made.refuse("torque_constant", "is also stated as torque_constant of the entry; keep one of them")
    if own is not None:
        word = "dc" if made.six_step else "rms"
        figures["torque_constant"] = Figure(
            f"{own[0]:.4g} N*m/A {word}" if own[0] == own[1] else f"{own[0]:.4g}..{own[1]:.4g} N*m/A {word}",
            f"{own[0]!r} N*m/A", f"{own[1]!r} N*m/A", frozenset({word}),
        )  # fmt: skip
    if not figures:
        return None
    pairs = [int(end) for end in dict.fromkeys(made.stated("pole_pairs", "1") or ())]
    for key, figure in figures.items():
        try:
            torque_constant({key: figure}, six_step=made.six_step)
        except UnitError as error:
            raise made.refuse(key, str(error)) from None
    found = torque_constant(figures, six_step=made.six_step, pole_pairs=pairs)
    if found.contradiction:
        key = next(key for key in ("voltage_constant", "speed_constant", "torque_constant") if key in figures)
        raise made.refuse(key, found.contradiction)
    return Converted("torque_constant", found.low, found.high, "N*m/Arms", found.words, found.key)


def _rated_power(figure: Figure) -> Converted:
    said = f"rated power {figure.text}"
    return continuous("rated_power", "W", figure, figure.quantity("W"), key="rated_power", said=said)


def _rated_current(figure: Figure, *, six_step: bool) -> Converted:
    low, high, how = current_range(figure, six_step=six_step)
    return Converted("rated_current", low, high, "Arms", f"rated current {figure.text}, {how}", "rated_current")


def _windings(made: _Sheet) -> Iterator[Converted]:
    sheet = made.sheet
    phases: dict[str, Converted] = {}
    for key in UNITS:
        if getattr(sheet, key) is not None:
            phases[key] = _read(made, key, lambda figure, key=key: phase_value(key, figure, winding=sheet.winding))
            yield phases[key]
    if sheet.electrical_time_constant is None:
        return
    resistance = made.stated("phase_resistance", "ohm")
    if "resistance" in phases:
        resistance = (phases["resistance"].low, phases["resistance"].high)
    if resistance is None:
        raise made.refuse("electrical_time_constant", "is L / R, but no resistance is printed; add resistance")
    if "inductance" in phases or "phase_inductance" in made.document.data:
        raise made.refuse("electrical_time_constant", "and the inductance are both printed; keep the inductance")
    yield _read(made, "electrical_time_constant", lambda figure: inductance_from_time_constant(figure, resistance))


def _frictions(made: _Sheet, constant: Converted | None) -> Iterable[Converted]:
    current, speed = made.sheet.no_load_current, made.sheet.no_load_speed
    if current is None and speed is None:
        return []
    if current is None or speed is None:
        missing = "no_load_current" if current is None else "no_load_speed"
        given = "no_load_speed" if current is None else "no_load_current"
        raise made.refuse(given, f"gives the friction only with {missing}; add it, or remove this")
    if constant is None:
        raise made.refuse(
            "no_load_current", "gives a torque only with Kt or Ke; add torque_constant or voltage_constant"
        )
    try:
        return friction(current, speed, constant=(constant.low, constant.high), six_step=made.six_step)
    except UnitError as error:
        raise made.refuse("no_load_current", str(error)) from None


def _put(made: _Sheet, data: dict[str, Any], one: Converted) -> None:
    """Write a converted value into ``data``; InputError where the entry states it itself."""
    name, _, inner = one.field.partition(".")
    place = data
    if inner:
        place = data[name] = dict(data.get(name) or {})
        name = inner
    if name in place:
        raise InputError(
            f"{made.document.place(one.field.split('.'))}: is also in as_printed ({one.key}); keep one of them"
        )
    figure = made.sheet.figures().get(one.key)
    low, high = (written_quantity(float(f"{end:.12g}"), one.unit) for end in (one.low, one.high))
    if one.unit == "1":
        low, high = float(f"{one.low:.12g}"), float(f"{one.high:.12g}")  # type: ignore[assignment]
    bounds = {"value": low} if low == high else {"low": low, "high": high}
    note = (f"{MARK}{one.words}" if one.words else "") + (f"; {figure.note}" if figure and figure.note else "")
    place[name] = {
        **bounds,
        "evidence": (figure.evidence if figure else "") or made.sheet.evidence,
        "source": (figure.source if figure else "") or made.sheet.source,
        "note": note,
    }
