"""The answers of what-ifs: by the integrator, sampled and filtered as the command line does it."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

from torquerig.api.simulated import sample_rate_of
from torquerig.catalog.reading import Catalog, load_catalog
from torquerig.catalog.search import catalog_folders
from torquerig.catalog.shipped import shipped_scenarios
from torquerig.document import Document, parse_document, read_document
from torquerig.errors import InputError, did_you_mean
from torquerig.filters.chains.chain_file import chain_texts, made_chain, needs_response
from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.filter_effect import chain_effect
from torquerig.metrics.sizing.drive_sizing import sizing
from torquerig.metrics.sizing.sized_drive import sized_drive
from torquerig.metrics.truth_error import true_load, truth_error
from torquerig.orders.kinematics.order_report_text import name_of
from torquerig.recordings.recording import Recording
from torquerig.reporting.sizing.sizing_text import sizing_rows, verdict_text
from torquerig.scenario.kinematics import kinematics_of, ratio_text
from torquerig.scenario.load_response import load_response
from torquerig.scenario.model import Scenario
from torquerig.scenario.overrides import overridden
from torquerig.simulation.loop_stability import loop_warning
from torquerig.simulation.simulator import simulate
from torquerig.studio.what_if.answer import LineRow, Simulated, Sized
from torquerig.studio.what_if.plots import signal_view, spectrum_view
from torquerig.studio.what_if.question import LENGTH, Question
from torquerig.study.one_drive import scenario_or_candidate
from torquerig.study.sized_candidates import with_cycle

Kept = TypeVar("Kept")
MOST_KEPT = 8  # recordings of the last questions: 8 x 2 s of ten channels are 32 MB
HARMONICS = 4  # of each cause, as in the report of `torquerig filter`


@dataclass
class WhatIf:
    """Answers questions; keeps what a later one needs again: the catalog, the last recordings and sizings."""

    _kept: OrderedDict[Hashable, Any] = field(default_factory=OrderedDict, repr=False)

    def simulated(self, question: Question) -> Simulated:
        """Return what the sensor records in the changed rig, before and after the filter chain.

        Raises
        ------
        InputError
            For a scenario, change or chain that cannot be used.
        SimulationError
            Where the state becomes non-finite.
        """
        made, before = self._recording(question)
        chain = _chain(question, made)
        after = chain.apply(before)
        kinematics, has_load = kinematics_of(made.rig), true_load(before) is not None
        effect = chain_effect(before, after, ratio=kinematics.ratio, lines=kinematics.lines(HARMONICS))
        doubts = (*before.origin.get("warnings", ()), loop_warning(made.rig, rate=before.sample_rate))
        return Simulated(
            title=_title(made), unit=before.torque_unit(), mean=effect.mean_before, std=effect.std_before,
            error_before=truth_error(before, before) if has_load else None,
            error_after=truth_error(after, before) if has_load else None,
            lines=tuple(sorted(
                (LineRow(cause=name_of(one.line), family=one.line.family, order=one.line.output_order,
                         frequency=one.frequency, before=one.before, after=one.after) for one in effect.levels),
                key=lambda row: -row.before,
            )),
            left_out=tuple(chain.left_out), warnings=tuple(filter(None, doubts)),
            signal=signal_view(before, after), spectrum=spectrum_view(before, after, effect.levels),
        )  # fmt: skip

    def sized(self, question: Question) -> Sized:
        """Return whether the changed drive is large enough, as ``torquerig size`` does; InputError for bad input."""
        stamp, catalog = self._catalog(question)
        return self._once(("sizing", *_drive_key(question), stamp), lambda: _sized(question, catalog))

    def catalog(self, question: Question) -> Catalog:
        """Return the catalog of a question's scenario; read again where a file of it has changed."""
        return self._catalog(question)[1]

    def _recording(self, question: Question) -> tuple[Scenario, Recording]:
        stamp, catalog = self._catalog(question)

        def run() -> tuple[Scenario, Recording]:
            made = _scenario(question, catalog, _document(question))
            return made, simulate(
                made.rig, duration=LENGTH, seed=question.seed, sample_rate=sample_rate_of(made),
                settling=made.recording.settling, wander=made.operating_point.slow_speed_wander, scenario=made.title,
            )  # fmt: skip

        return self._once(("recording", *_drive_key(question), stamp), run)

    def _catalog(self, question: Question) -> tuple[Hashable, Catalog]:
        folders = catalog_folders(question.path, question.catalogs)
        stamp = _stamp(folders)
        return stamp, self._once(("catalog", stamp), lambda: load_catalog(*folders))

    def _once(self, key: Hashable, make: Callable[[], Kept]) -> Kept:
        """Return what was made for this key, or make it; the oldest of a kind is dropped. An error is not kept."""
        if key not in self._kept:
            self._kept[key] = make()
            assert isinstance(key, tuple)
            same = [one for one in self._kept if isinstance(one, tuple) and one[0] == key[0]]
            for old in same[: max(len(same) - MOST_KEPT, 0)]:
                del self._kept[old]
        self._kept.move_to_end(key)
        found: Kept = self._kept[key]
        return found


def _drive_key(question: Question) -> tuple[Hashable, ...]:
    return question.path, question.text, question.motor, question.gearbox, question.settings, question.seed


def _stamp(folders: list[Path]) -> tuple[tuple[str, int, int], ...]:
    """Return name, time and size of every file, which change when a catalog is edited."""
    found = [file for folder in folders for file in sorted(folder.rglob("*.y*ml"))]
    return tuple((str(file), (state := file.stat()).st_mtime_ns, state.st_size) for file in found)


def _document(question: Question) -> Document:
    return overridden(parse_document(question.text, question.path), question.written_settings())


def _scenario(question: Question, catalog: Catalog, document: Document) -> Scenario:
    return scenario_or_candidate(
        document, catalog, motor=question.motor or None, gearbox=question.gearbox or None, seed=question.seed
    )


def _sized(question: Question, catalog: Catalog) -> Sized:
    made = _scenario(question, catalog, with_cycle(_document(question)))
    found = sizing(sized_drive(made, catalog))
    values = {name: figure.value for name, figure in found.figures.items() if figure.value is not None}
    return Sized(verdict=found.verdict, sentence=verdict_text(found), values=values,
                 rows=tuple(tuple(row) for row in sizing_rows(found)))  # fmt: skip


def chain_file(path: Path, data: Any) -> Path:
    """Return the file of filter chains of a scenario: that of its study, else the shipped one."""
    study = data.get("study") if isinstance(data, dict) else None
    filters = study.get("filters") if isinstance(study, dict) else None
    stated = filters.get("file") if isinstance(filters, dict) else None
    return path.parent / stated if isinstance(stated, str) else shipped_scenarios() / "filters.yaml"


def _chain(question: Question, made: Scenario) -> Chain:
    document = read_document(chain_file(question.path, made.document.data))
    texts = chain_texts(document)
    if question.chain not in texts:
        raise InputError(f"{document.path}: there is no filter chain {question.chain!r}; "
                         f"{did_you_mean(question.chain, texts)}")  # fmt: skip
    is_needed = needs_response(document, (question.chain,))
    response = load_response(made.rig, rate=sample_rate_of(made)) if is_needed else None
    return made_chain(question.chain, texts[question.chain], kinematics=kinematics_of(made.rig), response=response)


def _title(made: Scenario) -> str:
    run = made.rig.run
    speed = "" if run.speed_rpm is None else f", motor at {run.speed_rpm:.5g} rpm"
    load = "" if run.occupancy_percent is None else f", occupancy {run.occupancy_percent:g} %"
    return f"{run.motor or made.title}, {ratio_text(made.rig)}{speed}{load}"
