"""Results of a study before the decision: per drive and filter."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING

from torquerig.metrics.figure import Figure
from torquerig.version import __version__

if TYPE_CHECKING:
    from torquerig.cases.kept_results import KeptResults
    from torquerig.filters.filter_effect import FilterEffect
    from torquerig.metrics.load_path import LoadPath
    from torquerig.metrics.shares import Shares
    from torquerig.recordings.recording import Recording
    from torquerig.scenario.catalog_values.filled import FromCatalog
    from torquerig.study.candidate import Candidate
    from torquerig.study.definition import Study
    from torquerig.study.loop_figures import LoopMargin


@dataclass(frozen=True, kw_only=True)
class ChainResult:
    """One filter on one drive; ``residual_disturbance`` [N m] is unknown unless a criterion uses it.

    ``random_error`` is the standard error of the reading error [N m] by the randomness of the load, from blocks of the
    first sample's record; None for a record that is too short. More data sheets do not lower it, a longer record does.
    """

    chain: str
    effect: FilterEffect
    truth_error: Figure
    left_out: tuple[str, ...]
    random_error: float | None = None
    residual_disturbance: Figure = field(default_factory=lambda: Figure(missing="a criterion that uses it"))


@dataclass(frozen=True, kw_only=True)
class DriveResult:
    """One motor on one gearbox.

    Parameters
    ----------
    candidate : Candidate
    margins : mapping of str to Figure
        Speed, torque, sensor, parts and price; see metrics/drive_margins.
    out_of_reach : str
        Why it was not simulated; empty if it was.
    motor_speed : float
        [rad/s]
    torque_limit, kp : float
        As set by the study's rules [N m], [N m s/rad].
    assumed : mapping of str to str
        Values that no document states, with the interval that they were drawn from.
    shares : Shares or None
    disturbance : Figure
        Rms of the lines in the unfiltered reading over the Monte Carlo samples [N m].
    load_path : LoadPath or None
        What the shafts make of the load on its way to the sensor.
    chains : mapping of str to ChainResult
    loop : LoopMargin or None
        How far the tuned speed loop is from instability.
    unstable_samples : int
        Samples of the catalog whose speed loop is unstable; they have no part in the figures.
    omitted : Figure
        Rms at the sensor of a commutation ripple that the motor's known lines leave out [N m]; unknown where none is.
    taken : mapping of str to FromCatalog
        Catalog values of the simulated rig, by ``part.field``.
    duration : float
        Length of the simulated recordings [s]; 0 for a drive that was not simulated.
    simulated : function or None
        Returns the recording of the first sample.
    """

    candidate: Candidate
    margins: Mapping[str, Figure]
    out_of_reach: str
    motor_speed: float
    torque_limit: float
    kp: float
    assumed: Mapping[str, str]
    shares: Shares | None
    disturbance: Figure
    chains: Mapping[str, ChainResult]
    load_path: LoadPath | None = None
    loop: LoopMargin | None = None
    unstable_samples: int = 0
    omitted: Figure = field(default_factory=lambda: Figure(unit="N*m"))
    taken: Mapping[str, FromCatalog] = field(default_factory=dict)
    duration: float = 0.0
    simulated: Callable[[], Recording] | None = field(default=None, repr=False, compare=False)

    @cached_property
    def recording(self) -> Recording | None:
        """The reading of the first sample with its truth, simulated again when it is first asked for.

        The recordings of thirty drives would take 0.5 GiB, and few of them are looked at.
        """
        return None if self.simulated is None else self.simulated()


@dataclass(frozen=True, kw_only=True)
class Point:
    """The operating point of all drives.

    Parameters
    ----------
    mean_load : float
        Mean torque at the wear part, load and drag [N m].
    occupancy_percent, particle_size, output_speed : float
        [%], [m], [rad/s], in a line [m/s].
    """

    mean_load: float
    occupancy_percent: float
    particle_size: float
    output_speed: float


@dataclass(frozen=True, kw_only=True)
class StudyRuns:
    """All simulated drives and their figures.

    Parameters
    ----------
    mean_load : float
        Mean torque at the wear part, load and drag [N m].
    occupancy_percent, particle_size, output_speed : float
        The operating point [%], [m], [rad/s], in a line [m/s].
    from_store : int
        How many drives were read from kept results; the figures do not depend on it.
    kept : KeptResults or None
        Where results that are made of these, such as pictures, are kept too.
    row_keys : mapping of str to str
        Digest of all that the figures of a drive depend on, by its name; empty where nothing is kept.
    """

    study: Study
    drives: tuple[DriveResult, ...]
    mean_load: float
    occupancy_percent: float
    particle_size: float
    output_speed: float
    version: str = __version__
    from_store: int = field(default=0, repr=False, compare=False)
    kept: KeptResults | None = field(default=None, repr=False, compare=False)
    row_keys: Mapping[str, str] = field(default_factory=dict, repr=False, compare=False)
