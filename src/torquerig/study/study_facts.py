"""What a scenario states for all drives of a study and its pages repeat."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from torquerig.cases.kept_values import kept_or_made

if TYPE_CHECKING:
    from collections.abc import Mapping

    from torquerig.study.results import StudyRuns

CLASSES = frozenset({"torquerig.study.study_facts:StudyFacts"})


@dataclass(frozen=True, kw_only=True)
class StudyFacts:
    """Facts of a study that neither a weight nor a limit changes.

    Parameters
    ----------
    wander : float
        Slow speed wander, rms relative to the speed [1].
    rate : float
        Sample rate [Hz].
    held : str
        Which uncertain numbers no sample varies, in a sentence; empty for none.
    left_out : mapping of str to tuple of str
        Effects of the present stage that a stage cannot have, by stage.
    """

    wander: float
    rate: float
    held: str
    left_out: Mapping[str, tuple[str, ...]]


def study_facts(runs: StudyRuns) -> StudyFacts:
    """Return the facts of a study, kept or read from its scenario now."""

    def read() -> StudyFacts:
        from torquerig.scenario.conditions.recording_settings import RecordingSettings
        from torquerig.scenario.sections import read_operating_point, read_section
        from torquerig.study.exchanged_data import left_out_effects
        from torquerig.study.held_numbers import held_sentence

        study = runs.study
        boxes = dict.fromkeys(drive.candidate.gearbox for drive in runs.drives)
        return StudyFacts(
            wander=read_operating_point(study.document, seed=study.settings.seed)[0].slow_speed_wander,
            rate=read_section(study.document, "recording", RecordingSettings).sample_rate,
            held=held_sentence(study),
            left_out={box: left_out_effects(box, study) for box in boxes},
        )

    return kept_or_made(runs.kept, "facts", list(runs.row_keys.values()), read, classes=CLASSES)
