"""The answer of a diagnosis page, from the diagnosis as JSON: what is missing, how large, how sure, what to do next.

It reads the contract's form.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from torquerig.reporting.diagnosis.likelihood.sentences import nothing_missing
from torquerig.reporting.diagnosis.sentences import fact_text, mechanism_text
from torquerig.reporting.layout import plain
from torquerig.study.answer.what_to_do import LargeFigure

LONGEST = 25  # words of a sentence on the first screen
NAMED = 3  # mechanisms that the first sentence names
TONES = {"adequate": "good", "missing_physics": "poor", "setup_error": "poor"}
"""CSS class of the answer: blue, orange, and violet for what remains unexplained."""
PLACES = {
    "order_output": "{} per output turn", "order_motor": "{} per motor turn", "frequency_Hz": "{} Hz",
    "cutoff_Hz": "{} Hz",
}  # fmt: skip
"""Where an effect is, by parameters of the contract, the first that is known."""
SIZES = {
    "amplitude_Nm": "{} N m", "amplitude_A": "{} A", "amplitude_V": "{} V", "coulomb_Nm": "{} N m",
    "gap_arcmin": "{} arcmin", "span_V": "{} V", "limit_V": "{} V", "step_V": "{} V", "depth": "{} of the torque",
}  # fmt: skip
"""How large it is, likewise."""
_NEXT = {
    "adequate": "Next: use the scenario as it is. Runs at other speeds and loads can show smaller effects.",
    "missing_physics": "Next: check the named part on the rig, and continue with the completed scenario.",
    "setup_error": "Next: correct the named fact in the scenario or sidecar, and run the diagnosis again.",
    "unexplained": "Next: record runs at two more speeds and one more load, and add them to the diagnosis.",
}


@dataclass(frozen=True, kw_only=True)
class DiagnosisAnswer:
    """What the first screen of a diagnosis shows."""

    sentences: tuple[str, ...]
    figures: tuple[LargeFigure, ...]
    tone: str


def diagnosis_answer(data: Mapping[str, Any], *, percent: bool) -> DiagnosisAnswer:
    """Return the answer of a diagnosis in the contract's form.

    Parameters
    ----------
    percent : bool
        Whether the residual on held-out data is a share of the measured signal; else it is a mean square.
    """
    return DiagnosisAnswer(
        sentences=(_missing(data), *_size(data), _sure(data), *_next(data)),
        figures=(_size_figure(data), _sure_figure(data), _residual_figure(data, percent=percent)),
        tone=TONES.get(str(data["verdict"]), "open"),
    )


def _missing(data: Mapping[str, Any]) -> str:
    verdict, names = data["verdict"], [_named(one) for one in data["findings"]]
    if verdict == "adequate":
        return nothing_missing(data)
    if verdict == "setup_error":
        first = data["setup"][0]
        right, stated = _number(first["estimated"], 5), plain(first["stated"], 5)
        return f"A set-up fact is wrong: {fact_text(first)} is {right}, stated is {stated}."
    if not names:
        return "Something is missing that no mechanism of the library explains."
    rest = "" if verdict == "missing_physics" else " Something more is missing that no mechanism explains."
    return f"The model lacks {_listed(names)}.{rest}"


def _named(finding: Mapping[str, Any]) -> str:
    """Return the mechanism with the place and size that identify it, as far as they are estimated."""
    known = finding["parameters"]
    facts = (
        next((form.format(plain(known[key]["value"])) for key, form in forms.items() if key in known), "")
        for forms in (PLACES, SIZES)
    )
    shown = ", ".join(filter(None, facts))
    name = mechanism_text(finding["mechanism"])
    return f"{name} ({shown})" if shown else name


def _listed(names: Sequence[str]) -> str:
    if len(names) > NAMED:
        return f"{', '.join(names[:NAMED])} and {len(names) - NAMED} more"
    return " and ".join(filter(None, (", ".join(names[:-1]), names[-1])))


def _size(data: Mapping[str, Any]) -> tuple[str, ...]:
    rms = data.get("rms")
    if not rms:
        return ()
    unit = str(rms["unit"]).replace("*", " ")
    return (f"The residual on held-out data falls from {plain(rms['before'])} to {plain(rms['after'])} {unit} rms.",)


def _sure(data: Mapping[str, Any]) -> str:
    listed = [*data.get("setup", ()), *data["findings"]]
    if not listed:
        return "How sure: the residual on held-out data and the limits are below."
    first = listed[0]
    name = _named_first(first)
    alike = [mechanism_text(one) for one in first["equivalent_to"]]
    doubt = f"; these recordings do not distinguish it from {_listed(alike)}" if alike else ""
    return f"How sure: {100 * first['confidence']:.0f} % for {name}{doubt}."


def _next(data: Mapping[str, Any]) -> tuple[str, ...]:
    """Return the next run that the diagnosis names, in full where it is short, else where to read it."""
    runs = [one.get("next_experiment") for one in data["findings"]] + [data.get("next_experiment")]
    named = next((str(run) for run in runs if run), None)
    if named is None:
        return (_NEXT[data["verdict"]],)
    if all(len(sentence.split()) < LONGEST for sentence in named.split(". ")):
        return (f"Next run: {named.rstrip('.')}.",)
    return ("Next: record the run that the section Findings names.",)


def _size_figure(data: Mapping[str, Any]) -> LargeFigure:
    name = "change of the reading"
    sized = [one for one in data["findings"] if one.get("size")]
    if sized:
        first = max(sized, key=lambda one: one["size"]["value"])
        size = f"{plain(first['size']['value'])} {first['size']['unit'].replace('*', ' ')}"
        return LargeFigure(name=name, value=size, note=f"rms, by {mechanism_text(first['mechanism'])}")
    if data["findings"]:
        return LargeFigure(name=name, value="not computed", note="needs a simulation of the completed model")
    return LargeFigure(name=name, value="none", note="no finding changes the reading")


def _sure_figure(data: Mapping[str, Any]) -> LargeFigure:
    listed = [*data.get("setup", ()), *data["findings"]]
    if not listed:
        return LargeFigure(name="findings", value="0", note=str(data["verdict"]).replace("_", " "))
    value, name = listed[0]["confidence"], _named_first(listed[0])
    return LargeFigure(name="confidence", value=f"{100 * value:.0f} %", note=f"that it is {name}")


def _named_first(one: Mapping[str, Any]) -> str:
    """Return the name of a finding, or what fact of the set-up is wrong."""
    return mechanism_text(one["mechanism"]) if "mechanism" in one else fact_text(one)


def _residual_figure(data: Mapping[str, Any], *, percent: bool) -> LargeFigure:
    fit = data["fit"]
    before, after = (fit[side]["heldout_misfit"] for side in ("before", "after"))
    ends = [f"{plain(100 * one)} %" if percent else plain(one) for one in (before, after)]
    same = not data["findings"] or ends[0] == ends[1]
    note = "rms share of the signal, on held-out data" if percent else "mean square on held-out data; a true model: 1"
    return LargeFigure(name="standardised residual" if not percent else "residual",
                       value=ends[0] if same else f"{ends[0]} to {ends[1]}", note=note)  # fmt: skip


def _number(value: Mapping[str, Any], digits: int = 3) -> str:
    unit = "" if value["unit"] in ("1", "") else f" {value['unit'].replace('*', ' ')}"
    return f"{plain(value['value'], digits)}{unit}"
