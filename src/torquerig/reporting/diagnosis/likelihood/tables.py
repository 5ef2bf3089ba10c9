"""Tables of the answer, from the diagnosis in the contract's form."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from torquerig.inference.answer.mismatch import Mismatch
from torquerig.inference.fit import Fit
from torquerig.inference.knobs import Knob
from torquerig.inference.measured_run import MeasuredRun
from torquerig.reporting.diagnosis.sentences import mechanism_text
from torquerig.reporting.layout import Cell, Table, number, plain, words
from torquerig.rig.assembly import Rig


def parameters_table(finding: Mapping[str, Any]) -> Table:
    """Return the parameters of a finding with their 95 % intervals, and its size in the reading."""
    rows = [
        (*words(name), number(plain(each["value"], 4)), number(_interval(each)), Cell(text=_unit(each["unit"])))
        for name, each in finding["parameters"].items()
    ]
    size = finding["size"]
    rows.append((*words("change of the reading"), number(plain(size["value"])), number(""),
                 Cell(text=f"{_unit(size['unit'])} rms")))  # fmt: skip
    return Table(
        caption="Identified parameters", head=("parameter", "value", "95 % interval", "unit"), rows=tuple(rows)
    )


def alternatives_table(finding: Mapping[str, Any]) -> Table | None:
    """Return the hypotheses that were fitted in the place of a finding, and how far they are behind."""
    rows = [
        (*words(each["hypothesis"], mechanism_text(each["mechanism"] or "no name")),
         number(plain(each["nats_behind"])), *words(_judged(each, finding)))
        for each in finding["alternatives"]
    ]  # fmt: skip
    if not rows:
        return None
    return Table(
        caption="Alternative hypotheses, each fitted together with all parameters of the model",
        head=("hypothesis", "name", "behind [nats]", "judgement"), rows=tuple(rows),
        note="Behind: difference of the logarithm of the posterior odds. 3 nats are 20 to 1, 7 nats 1000 to 1.",
    )  # fmt: skip


def unnamed_table(rows: Sequence[Mapping[str, Any]]) -> Table | None:
    """Return the effects without a name: where, how large, how sure."""
    if not rows:
        return None
    return Table(
        caption="Effects without a name; they are in the completed model",
        head=("effect", "at", "acts as", "size", "95 % interval", "unit", "confidence", "it may be", "minor"),
        rows=tuple(
            (*words(mechanism_text(each["kind"]), f"{plain(each['at'], 5)} {_axis(each['axis'])}", each["acts_as"]),
             number(plain(each["size"]["value"])), number(_interval(each["size"])),
             Cell(text=_unit(each["size"]["unit"])), number(_percent(each["confidence"])),
             *words(", ".join(map(mechanism_text, each["equivalent_to"])), "yes" if each["minor"] else "no"))
            for each in rows
        ),
        note="Size: amplitude of lines, rms of noise. Minor: too small to change the verdict.",
    )  # fmt: skip


def setup_table(rows: Sequence[Mapping[str, Any]]) -> Table | None:
    """Return the facts of the set-up that contradict the recordings."""
    if not rows:
        return None
    return Table(
        caption="Set-up facts that look wrong",
        head=("fact", "of", "stated", "estimated", "95 % interval", "unit", "confidence", "or"),
        rows=tuple(
            (*words(mechanism_text(each["kind"]), each["of"]), number(plain(each["stated"], 5)),
             number(plain(each["estimated"]["value"], 5)), number(_interval(each["estimated"])),
             Cell(text=_unit(each["estimated"]["unit"])), number(_percent(each["confidence"])),
             *words(", ".join(map(mechanism_text, each["equivalent_to"]))))
            for each in rows
        ),
        note=" ".join(each["explanation"] for each in rows),
    )  # fmt: skip


def limits_table(rows: Sequence[Mapping[str, Any]]) -> Table | None:
    """Return the smallest size of each mechanism that the recordings would have shown."""
    if not rows:
        return None
    return Table(
        caption="Smallest sizes that these runs would have shown",
        head=("mechanism", "parameter", "size", "unit", "tested place"),
        rows=tuple(
            (*words(mechanism_text(each["mechanism"]), each["parameter"]),
             number(f"{'below' if each['grows'] == 'down' else 'from'} {plain(each['value'])}"),
             Cell(text=_unit(each["unit"])), *words(each["place"]))
            for each in rows
        ),
        note="In 95 % of such recordings. At other places the limit differs.",
    )  # fmt: skip


def errors_table(rms: Mapping[str, Any]) -> Table:
    """Return the rms error of each run before and after."""
    unit = _unit(rms["unit"])
    runs = [
        (*words(each["file"]), number(plain(each["before"])), number(plain(each["after"])))
        for each in rms["recordings"]
    ]
    total = (*words("all"), number(plain(rms["before"])), number(plain(rms["after"])))
    return Table(
        caption="Rms error on held-out data, run by run",
        head=("recording", f"nominal, calibrated [{unit}]", f"completed [{unit}]"), rows=(*runs, total),
        emphasised=frozenset({len(runs)}),
        note=f"Random errors of a true model make {plain(rms['true_model'])} {unit}; with the named effects only it is "
        f"{plain(rms['after_named_only'])} {unit}. The error is the smallest rms difference that two random processes "
        "with these spectra, lines and means can have.",
    )  # fmt: skip


def runs_table(rows: Sequence[Mapping[str, Any]]) -> Table:
    """Return the recordings with their mean speed and what they were used for."""
    use = {"split": "a third held out", "fit": "fitted", "held_out": "held out", "none": "not compared"}
    return Table(
        caption="The recordings", head=("recording", "mean speed [rpm]", "used for"),
        rows=tuple((*words(each["file"]), number(plain(each["speed_rpm"], 5)), *words(use[each["used_for"]]))
                   for each in rows),
    )  # fmt: skip


def conditions_table(rows: Sequence[Mapping[str, Any]], runs: Sequence[MeasuredRun]) -> Table:
    """Return the recordings with their conditions, the source of the shaft angle, and what they were used for."""
    by_name = {run.name: run for run in runs}
    plain_rows = {each["file"]: row for each, row in zip(rows, runs_table(rows).rows, strict=True)}
    made = []
    for name, (file, speed, use) in plain_rows.items():
        run = by_name[name]
        load = "" if run.run.occupancy_percent is None else f"{run.run.occupancy_percent:g} %"
        length, angle = f"{run.recording.duration:g}", "measured" if run.has_encoder else "estimated"
        made.append((file, *words(run.run.profile), speed, number(load), number(length), *words(angle), use))
    return Table(
        caption="The recordings", rows=tuple(made),
        head=("recording", "profile", "mean speed [rpm]", "occupancy", "length [s]", "shaft angle", "used for"),
    )  # fmt: skip


def mismatches(rows: Sequence[Mapping[str, Any]]) -> tuple[Mismatch, ...]:
    """Return the places where recordings and model differ, as values."""
    return tuple(Mismatch(**{**each, "recordings": tuple(each["recordings"])}) for each in rows)


@dataclass(frozen=True, eq=False)
class FittedParameters:
    """A fit in the form of the table of fitted parameters."""

    fit: Fit

    @cached_property
    def rig(self) -> Rig:
        """With every parameter at its estimate."""
        return self.fit.fitted_rig

    @property
    def knobs(self) -> tuple[Knob, ...]:
        """The parameters."""
        return self.fit.knobs

    @property
    def positions(self) -> NDArray[np.float64]:
        """Their estimates, in standard deviations of their priors."""
        return self.fit.positions

    @cached_property
    def covariance(self) -> NDArray[np.float64]:
        """Of the positions."""
        return self.fit.covariance()[: len(self.fit.knobs), : len(self.fit.knobs)]


def _judged(each: Mapping[str, Any], finding: Mapping[str, Any]) -> str:
    if each["mechanism"] in finding["equivalent_to"]:
        return "not distinguished by these recordings"
    return "same name, another place" if each["mechanism"] == finding["mechanism"] else "rejected: less likely"


def _interval(each: Mapping[str, Any]) -> str:
    low, high = each["ci95"]
    return "" if low == high else f"{plain(low, 4)} to {plain(high, 4)}"


def _axis(axis: str) -> str:
    return (
        axis
        if axis in ("Hz", "s", "rpm", "m", "cycles/m", "position", "speed", "time")
        else f"1/rev of {axis.replace('_', ' ')}"
    )


def _unit(unit: str) -> str:
    return "" if unit == "1" else unit.replace("*", " ")


def _percent(value: float) -> str:
    return f"{100 * value:.0f} %"
