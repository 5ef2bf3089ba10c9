"""Results of a study in the folder of kept results, each under all that it depends on."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.cases.content import content_digest
from torquerig.cases.kept_values import bytes_of, kept_or_made, read_value
from torquerig.study.settings import metrics_of

if TYPE_CHECKING:
    from torquerig.cases.kept_results import KeptResults
    from torquerig.recordings.recording import Recording
    from torquerig.study.candidate import Candidate
    from torquerig.study.definition import Study
    from torquerig.study.results import DriveResult, Point

CLASSES = frozenset({
    "torquerig.filters.filter_effect:FilterEffect", "torquerig.filters.filter_effect:LineLevel",
    "torquerig.metrics.figure:Figure", "torquerig.metrics.load_path:LoadPath", "torquerig.metrics.shares:Shares",
    "torquerig.orders.kinematics.kinematic_lines:KinematicLine", "torquerig.parameter:Estimate",
    "torquerig.scenario.catalog_values.filled:FromCatalog", "torquerig.study.candidate:Candidate",
    "torquerig.study.candidate:ExchangedParts", "torquerig.study.loop_figures:LoopMargin",
    "torquerig.study.results:ChainResult", "torquerig.study.results:DriveResult", "torquerig.study.results:Point",
})  # fmt: skip
"""What a result of a drive is made of."""
RATED_AFTERWARDS = ("requirements", "criteria", "all_points", "sweep")
"""Parts of a study that are applied to the figures; which metrics they use is part of a key, no limit or weight is."""
LISTED = ("motors", "gearboxes")
"""Lists of a study that say which drives there are; the drive itself is part of a key."""
OTHER_SHELVES = ("gearboxes", "sensors", "couplings")
LONGEST_NAME = 1000  # characters of a text that may name a file


@dataclass(frozen=True)
class KeptStudy:
    """The kept results of one study.

    Parameters
    ----------
    results : KeptResults
    study : Study
    """

    results: KeptResults
    study: Study

    def candidates(self) -> tuple[Candidate, ...] | None:
        """Return the drives of the study; None where they are not kept."""
        found: tuple[Candidate, ...] | None = read_value(self.results, self._candidates_key, CLASSES)
        return found

    def keep_candidates(self, listed: Sequence[Candidate]) -> None:
        """Keep the drives of the study."""
        self.results.put(self._candidates_key, bytes_of(tuple(listed)))

    def rows(self, listed: Sequence[Candidate]) -> dict[Candidate, DriveResult]:
        """Return the kept results by drive, without those that are not kept."""
        found = ((one, self._row(one)) for one in listed)
        return {one: row for one, row in found if row is not None}

    def keep(self, result: DriveResult) -> None:
        """Keep the result of a drive."""
        plain = replace(result, simulated=None)
        self.results.put(self.row_key(result.candidate), bytes_of(plain))

    def point(self, listed: Sequence[Candidate]) -> Point | None:
        """Return the operating point of the study; None where it is not kept."""
        found: Point | None = read_value(self.results, self._point_key(listed), CLASSES)
        return found

    def keep_point(self, listed: Sequence[Candidate], point: Point) -> None:
        """Keep the operating point of the study."""
        self.results.put(self._point_key(listed), bytes_of(point))

    def row_key(self, candidate: Candidate) -> str:
        """Return the key of a drive's result: a digest of all that its figures depend on."""
        entries = (self._entries["motors"][candidate.motor], self._entries["gearboxes"].get(candidate.gearbox))
        return self.results.key("drive", self._shared, candidate, entries)

    def _row(self, candidate: Candidate) -> DriveResult | None:
        found: DriveResult | None = read_value(self.results, self.row_key(candidate), CLASSES)
        if found is None or not found.duration:
            return found
        return replace(found, simulated=partial(_first_recording, candidate, self.study))

    def _point_key(self, listed: Sequence[Candidate]) -> str:
        return self.results.key("point", self.row_key(listed[0]))

    @cached_property
    def _candidates_key(self) -> str:
        settings = self.study.settings
        lists = (settings.motors, settings.gearboxes, settings.present.motor, settings.present.gearbox)
        return self.results.key("candidates", self._shared, lists, self._entries)

    @cached_property
    def _entries(self) -> Mapping[str, Mapping[str, str]]:
        """Digest of each entry of the catalog, by shelf and name; motors under their aliases too, in their order."""

        def read() -> dict[str, dict[str, str]]:
            catalog = self.study.catalog
            names = [*catalog.motors, *(alias.name for one in catalog.motors.values() for alias in one.aliases)]
            shelves = {"gearboxes": catalog.gearboxes, "sensors": catalog.sensors, "couplings": catalog.couplings}
            found = {name: {one: repr(entry) for one, entry in shelf.items()} for name, shelf in shelves.items()}
            found["motors"] = {name: repr(catalog.motor(name)) for name in names}
            return {
                shelf: {name: content_digest(text) for name, text in listed.items()} for shelf, listed in found.items()
            }

        digest = self.study.catalog.digest
        return kept_or_made(self.results if digest else None, "catalog", digest, read, classes=())

    @cached_property
    def _shared(self) -> str:
        """Digest of what all drives depend on."""
        study, entries = self.study, self._entries
        data = dict(study.document.data)
        data["study"] = {
            key: value for key, value in data["study"].items() if key not in (*RATED_AFTERWARDS, *LISTED)
        }  # fmt: skip
        rig = {name: one for name, one in data["rig"].items() if name != study.exchanged.motor}
        named = set(_texts({**data, "rig": rig}))
        others = [{name: one for name, one in entries[shelf].items() if name in named} for shelf in OTHER_SHELVES]
        motors = [
            entries["motors"].get(str(one["catalog"])) for one in rig.values()
            if isinstance(one, dict) and "catalog" in one
        ]  # fmt: skip
        files = _files(named | set(_texts(study.filters.data)), study.document.path.parent)
        held = {  # a point of a sweep has other settings than its document
            name: getattr(study.settings, name) for name in type(study.settings).model_fields
            if name not in (*RATED_AFTERWARDS, *LISTED)
        }  # fmt: skip
        stated = (data, held, sorted(metrics_of(study.settings)), study.filters.data)
        return content_digest(stated, others, motors, files)


def _first_recording(candidate: Candidate, study: Study) -> Recording:
    """Return the recording of the first sample, simulated again."""
    from torquerig.study.candidates import scenario_of
    from torquerig.study.sample_runs import first_recording

    return first_recording(scenario_of(candidate, study, seed=study.settings.seed), study)


def _texts(value: Any) -> Iterator[str]:
    """Yield every text in the data of a file."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for one in value.values():
            yield from _texts(one)
    elif isinstance(value, list | tuple):
        for one in value:
            yield from _texts(one)


def _files(texts: set[str], folder: Path) -> dict[str, str]:
    """Return the digest of each file that a text names, from a folder or from here, and of its sidecar."""
    found = {}
    for text in sorted(one for one in texts if 0 < len(one) < LONGEST_NAME and "\0" not in one):
        for path in (folder / text, Path(text)):
            if not _is_file(path):
                continue
            for file in (path, path.with_name(f"{path.name}.yaml"), path.with_suffix(".yaml")):
                if _is_file(file):
                    found[f"{text}: {file.name}"] = content_digest(file.read_bytes())
    return found


def _is_file(path: Path) -> bool:
    """Return whether a path is a file with an end: no pipe, no device, and no text that cannot be a path."""
    try:
        return path.is_file()
    except (OSError, ValueError):
        return False
