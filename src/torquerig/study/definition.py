"""A study as it is run: the scenario's document, its settings, the catalog and the filter chains' document."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.document import Document, read_document
from torquerig.errors import InputError, did_you_mean
from torquerig.scenario.sections import output_moves_in_a_line, with_current_names
from torquerig.study.exchange import exchanged_parts, present_stage
from torquerig.study.settings import Settings, read_settings

if TYPE_CHECKING:
    from torquerig.catalog.shelves import Catalog
    from torquerig.filters.chains.chain_file import Stages
    from torquerig.filters.chains.filter_chain import Chain
    from torquerig.scenario.model import Scenario
    from torquerig.study.candidate import ExchangedParts


@dataclass(frozen=True)
class Study:
    """Everything that a comparison reads; a run changes nothing in it."""

    document: Document
    settings: Settings
    catalog: Catalog
    filters: Document

    @cached_property
    def exchanged(self) -> ExchangedParts:
        """The parts of the rig that the candidates replace."""
        return exchanged_parts(self.document, self.settings)

    @property
    def present_gearbox(self) -> str:
        """The present stage by the name that candidates use; empty where the study exchanges none."""
        return present_stage(self.document, self.settings)

    @property
    def effort_unit(self) -> str:
        """The unit of what is measured: N*m, or N where it moves in a line."""
        return "N" if output_moves_in_a_line(self.document.data) else "N*m"

    @property
    def motors(self) -> tuple[str, ...]:
        """The motors to be compared; the present one where the study lists none."""
        stated = self.settings.motors
        return tuple(self.catalog.motors) if stated == "all" else stated or (self.settings.present.motor,)

    @property
    def gearboxes(self) -> tuple[str, ...]:
        """The stages to be compared; the present one where the study lists none, empty where it exchanges none."""
        return self.settings.gearboxes or ((self.present_gearbox,) if self.present_gearbox else ())

    def chains(self, scenario: Scenario, texts: Mapping[str, Stages] | None = None) -> Mapping[str, Chain]:
        """Return the study's filter chains and the present one, made for the kinematics of one scenario.

        Parameters
        ----------
        texts : mapping of str to tuple of StageForm, optional
            The stages of chains in place of those of the file, by chain.

        Raises
        ------
        InputError
            When the study names a chain that the file does not have.
        """
        from torquerig.filters.chains.chain_file import made_chain, needs_response
        from torquerig.scenario.kinematics import kinematics_of
        from torquerig.scenario.load_response import load_response

        wanted = dict.fromkeys((*self.settings.filters.names, self.settings.present.filter))
        rate, is_needed = scenario.recording.sample_rate, needs_response(self.filters, wanted)
        response = load_response(scenario.rig, rate=rate) if is_needed else None
        kinematics, stated = kinematics_of(scenario.rig), {**self.filter_texts, **(texts or {})}
        for name in wanted:
            if name not in stated:
                key = ("filters", "names") if name in self.settings.filters.names else ("present", "filter")
                raise InputError(
                    f"{self.document.place(('study', *key))}: unknown filter chain {name!r}: it is not in "
                    f"{self.filters.path.name}; {did_you_mean(name, stated)}"
                )
        return {name: made_chain(name, stated[name], kinematics=kinematics, response=response) for name in wanted}

    @cached_property
    def filter_texts(self) -> Mapping[str, Stages]:
        """The filter chains of the file, for any drive."""
        from torquerig.filters.chains.chain_file import chain_texts

        return chain_texts(self.filters)


def open_study(document: Document, catalog: Catalog) -> Study:
    """Return the study of a scenario's document; InputError with file, line and key for what cannot be used."""
    document = with_current_names(document)
    settings = read_settings(document)
    filters = read_document(Path(document.path).parent / settings.filters.file)
    return Study(document, settings, catalog, filters)
