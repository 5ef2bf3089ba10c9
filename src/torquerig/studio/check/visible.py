"""The job of the smallest visible sizes: what recordings would show of each mechanism, and which look alike."""

from __future__ import annotations

from dataclasses import dataclass

from torquerig.catalog.search import catalog_for
from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.studio.diagnosing.question import DiagnosisQuestion
from torquerig.studio.jobs.child import Report

HEAD = ("mechanism", "parameter", "size", "place")


@dataclass(frozen=True)
class Visible:
    """What recordings would show.

    Parameters
    ----------
    rows : tuple of rows
        Under ``HEAD``: the smallest size of each mechanism that 95 % of such runs would show.
    pairs : tuple of str
        Hypotheses that these runs do not separate, each with the run that does.
    """

    rows: tuple[tuple[str, ...], ...]
    pairs: tuple[str, ...]


def visible(question: DiagnosisQuestion, report: Report) -> Visible:
    """Return the smallest sizes that the recordings would show, by the fitted nominal rig.

    Raises
    ------
    InputError, RecordingError
        As a diagnosis.
    """
    from torquerig.inference.engine import prepared
    from torquerig.inference.isolability.beforehand import beforehand
    from torquerig.recordings.files import read_recording
    from torquerig.reporting.diagnosis.sentences import mechanism_text
    from torquerig.reporting.layout import plain
    from torquerig.rig.imposed_part import imposed_part
    from torquerig.scenario.reading import read_scenario
    from torquerig.scenario.recorded.as_compared import as_compared

    report(stage="reading the recordings")
    catalog = catalog_for(question.path, question.catalogs)
    scenario = read_scenario(parse_document(question.text, question.path), catalog, seed=question.seed)
    if imposed_part(scenario.rig) is not None:
        raise InputError("the smallest sizes of a rig whose motion was measured are not computed yet")
    compared = as_compared(scenario, [read_recording(path) for path in question.recordings])
    ready = prepared(compared.scenario, compared.recordings, held_out=[], progress=lambda stage: report(stage=stage))
    report(stage="computing what the recordings would show")
    found = beforehand(ready)
    return Visible(
        rows=tuple(
            (mechanism_text(each["mechanism"]), str(each["parameter"]),
             f"{'below' if each['grows'] == 'down' else 'from'} {plain(each['value'])} {each['unit']}",
             str(each["place"]))
            for each in found.upper_limits
        ),
        pairs=tuple(f"{each.one} from {each.other}. {each.next_experiment}" for each in found.inseparable),
    )  # fmt: skip
