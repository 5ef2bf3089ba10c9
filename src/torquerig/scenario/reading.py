"""Scenario file to Rig: parts in their order, values from the catalog, and their uncertainties."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any

from torquerig.catalog.reading import Catalog
from torquerig.document import Document, validated
from torquerig.errors import InputError, TorquerigError, did_you_mean
from torquerig.parameter import Estimate
from torquerig.rig.assembly import HOST_FIELDS, Part, Rig
from torquerig.scenario.catalog_values.filled import Filled, FromCatalog
from torquerig.scenario.catalog_values.from_catalog import filled_from_catalog
from torquerig.scenario.catalog_values.phase_level import is_from_phase_level, with_phase_level
from torquerig.scenario.checks.misplaced import place_of
from torquerig.scenario.conditions.operating_point import OperatingPoint, run_at
from torquerig.scenario.conditions.recording_settings import RecordingSettings
from torquerig.scenario.kept_readings import KeptReadings
from torquerig.scenario.kinds import KINDS
from torquerig.scenario.measured import with_measured
from torquerig.scenario.model import Scenario
from torquerig.scenario.numbers.uncertain import resolved
from torquerig.scenario.overrides import naming_edits
from torquerig.scenario.sections import read_operating_point, read_section, sections_of
from torquerig.section_schema import schema_of


def read_scenario(document: Document, catalog: Catalog, *, seed: int) -> Scenario:
    """Return the scenario of a document; ``seed`` fixes what is drawn where the catalog has only an interval.

    Raises
    ------
    InputError
        With file, line, key and remedy, for everything that cannot be used.
    """
    return ScenarioReader(document, catalog).at(seed)


@dataclass(frozen=True)
class ScenarioReader:
    """A scenario to be read with many seeds: sections and parts that draw nothing are read once.

    What is kept depends on the document and the catalog alone. Both are values in memory: a file that changes later
    changes neither.

    Parameters
    ----------
    document : Document
    catalog : Catalog
    """

    document: Document
    catalog: Catalog
    _kept: KeptReadings = field(default_factory=KeptReadings, init=False, repr=False, compare=False)

    def at(self, seed: int) -> Scenario:
        """Return the scenario with the values of a seed; raises as :func:`read_scenario`."""
        try:
            return replace(self._read(seed), catalog=self.catalog, seed=seed)
        except TorquerigError as error:
            raise naming_edits(self.document, error) from None

    def _read(self, seed: int) -> Scenario:
        document, kept = self.document, self._kept
        data = kept.once("sections", seed, lambda _: sections_of(document))
        point, stated = kept.once("operating_point", seed, lambda at: read_operating_point(document, seed=at))
        recorded = kept.once("recording", seed, lambda _: read_section(document, "recording", RecordingSettings))
        found: list[Part] = []
        owners: dict[str, str] = {}
        uncertainties: dict[str, Estimate] = stated.named("operating_point", stated.estimates)
        assumed: dict[str, str] = stated.named("operating_point", stated.assumed)
        given: dict[str, str] = stated.named("operating_point", stated.kept)
        taken: dict[str, FromCatalog] = {}
        shaft: str | None = None
        for name, written in data["rig"].items():
            read = partial(self._parts, name, written, shaft)
            for item, part in kept.once(("rig", name, shaft), seed, read):
                with _placed(document, "rig", name):
                    Rig((*found, part))
                found.append(part)
                owners[part.name] = name
                for key, spread in item.uncertainties.items():
                    uncertainties[f"{part.name}.{key}"] = Estimate(getattr(part, key), rel_sd=spread, evidence="REF")
                uncertainties.update({f"{part.name}.{path}": known for path, known in item.stated.items()})
                given.update({f"{part.name}.{path}": text for path, text in item.kept.items()})
                assumed.update({f"{part.name}.{key}": text for key, text in item.assumed.items()})
                taken.update({f"{part.name}.{key}": one for key, one in item.taken.items()})
                shaft = part.name if part.on_shaft and not part.ends_shaft else shaft
        rig = _runnable(document, with_measured(Rig(tuple(found)), document), point, owners)
        title = str(data.get("scenario", document.path.stem))
        return Scenario(document, title, point, rig, uncertainties, assumed, taken, recording=recorded, kept=given)

    def _parts(self, name: str, written: Any, shaft: str | None, seed: int) -> tuple[tuple[Filled, Part], ...]:
        """Return the part ``name`` of the file and the effects that come with it, each with its data."""
        filled = _filled(self.document, name, written, shaft, catalog=self.catalog, seed=seed)
        made = []
        for item in (filled, *filled.effects):
            part = _part(self.document, name, item, shaft)
            made.append((item, part))
            shaft = part.name if part.on_shaft and not part.ends_shaft else shaft
        return tuple(made)


def _runnable(document: Document, rig: Rig, point: OperatingPoint, owners: Mapping[str, str]) -> Rig:
    """Return the rig at its operating point, the terms of every part checked so that errors have a place."""
    with _placed(document, "rig"):
        rig = rig.at(run_at(point, rig, folder=document.path.parent))
    for part in rig.parts:
        with _placed(document, "rig", owners[part.name]):
            part.terms(rig)
    # a stage may depend on the whole rig, so that the terms of all parts are checked first
    for part in rig.parts:
        with _placed(document, "rig", owners[part.name]):
            part.stages(rig)
    with _placed(document, "rig"):
        rig.terms()
    return rig


@contextmanager
def _placed(document: Document, *keys: str) -> Iterator[None]:
    """Put file, line and key before the errors of the parts themselves, which know no file."""
    try:
        yield
    except TorquerigError as error:
        raise InputError(f"{document.place(keys)}: {str(error).removeprefix(f'{keys[-1]}: ')}") from None


def _filled(
    document: Document, name: str, written: Any, shaft: str | None, *, catalog: Catalog, seed: int
) -> Filled:  # fmt: skip
    place = document.place(("rig", name))
    if not isinstance(written, dict) or "kind" not in written:
        raise InputError(f"{place}: a part needs its kind; add kind: with one of {', '.join(sorted(KINDS))}")
    if not isinstance(written["kind"], str) or written["kind"] not in KINDS:
        raise InputError(
            f"{document.place(('rig', name, 'kind'))}: {written['kind']!r} is no kind of part; "
            f"{did_you_mean(str(written['kind']), KINDS)}"
        )
    cls = KINDS[written["kind"]]
    read = resolved(
        written, cls, owner=name, seed=seed, place=lambda path: document.place(("rig", name, *path)),
        in_a_line=_in_a_line(document, cls, {"after": shaft, **written} if cls.on_shaft else written),
    )  # fmt: skip
    stated = {"from_" if key == "from" and hasattr(cls, "from_") else key: of for key, of in read.values.items()}
    if isinstance(stated.get("recording"), str):  # from the folder of the scenario, wherever it is read from
        stated["recording"] = str(document.path.parent / stated["recording"])
    entry = stated.pop("catalog", None)
    by_phases = stated["kind"] == "motor" and "ripple" in stated and is_from_phase_level(
        stated.pop("ripple"), document.place(("rig", name, "ripple")))  # fmt: skip
    if entry is None and by_phases:
        raise InputError(f"{document.place(('rig', name, 'ripple'))}: only a motor of the catalog has phases; "
                         "state parts of kind motor_phases and six_step_commutation instead")  # fmt: skip
    if entry is None:
        return Filled(name=name, values=stated, stated=read.estimates, kept=read.kept, assumed=read.assumed)
    filled = filled_from_catalog(catalog, str(entry), kind=stated["kind"], name=name, seed=seed, place=place)
    filled = filled.without({*stated, *read.uncertain})
    filled = replace(filled, values={**filled.values, **stated}, stated=read.estimates, kept=read.kept,
                     assumed={**filled.assumed, **read.assumed})  # fmt: skip
    if not by_phases:
        return filled
    with _placed(document, "rig", name, "ripple"):
        return with_phase_level(filled, catalog.motor(str(entry)), seed=seed)


def _part(document: Document, name: str, item: Filled, shaft: str | None) -> Part:
    cls = KINDS[item.values["kind"]]
    data = {"name": item.name, **item.values}
    if cls.on_shaft:
        data.setdefault("after", shaft)
    units = {"in_a_line": _in_a_line(document, cls, data)}
    elsewhere = partial(place_of, data=document.data, here=f"rig.{name}")
    return validated(document, schema_of(cls), within=("rig", name), data=data, context=units, elsewhere=elsewhere)


def _in_a_line(document: Document, cls: type[Part], data: Mapping[str, Any]) -> bool:
    """Return whether the numbers of a part are those of linear motion."""
    return cls.in_a_line or _kind_of(document, _host(cls, data)).in_a_line


def _host(cls: type[Part], data: Mapping[str, Any]) -> Any:
    """Return the name of the part that an effect is going to sit on, as ``Part.host`` does once it is read."""
    stated = [data.get(key, getattr(cls, key, None)) for key in HOST_FIELDS]
    return next((one for one in stated if one is not None), data.get("after") if cls.ends_shaft else None)


def _kind_of(document: Document, name: Any) -> type[Part]:
    """Return the class of a part of the file; Part where the file does not have it."""
    entry = document.data["rig"].get(name) if isinstance(name, str) else None
    return KINDS.get(str(entry.get("kind")), Part) if isinstance(entry, dict) else Part
