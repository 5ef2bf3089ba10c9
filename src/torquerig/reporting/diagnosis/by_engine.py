"""A diagnosis by the engine that is chosen."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from torquerig.recordings.recording import Recording
from torquerig.reporting.diagnosis.diagnosed import Diagnosed
from torquerig.scenario.model import Scenario

Progress = Callable[[str], None]


def diagnosed_by(
    engine: str, scenario: Scenario, recordings: Sequence[Recording], *, held_out: Sequence[str] = (), seed: int = 0,
    progress: Progress = lambda _: None,
) -> Diagnosed:  # fmt: skip
    """Return the diagnosis by the engine ``rules`` or ``likelihood``.

    Parameters
    ----------
    held_out : sequence of str
        Names of recordings that are not fitted and judge the models; only of the engine ``likelihood``.
    progress : callable
        Called with the name of each stage.

    Raises
    ------
    InputError, RecordingError
        Where scenario and recordings do not fit each other.
    """
    if engine == "rules":
        from torquerig.reporting.diagnosis.rules.made import diagnosed_by_rules

        return diagnosed_by_rules(scenario, recordings, seed=seed, progress=progress)
    from torquerig.reporting.diagnosis.likelihood.made import diagnosed_by_likelihood

    return diagnosed_by_likelihood(scenario, recordings, held_out=held_out, seed=seed, progress=progress)
