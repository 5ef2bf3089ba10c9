"""A gear only loses: a rig at standstill, with hardly any damping, never gains energy from it."""

from __future__ import annotations

import numpy as np
import pytest

from torquerig.recordings.run import Run
from torquerig.rig.assembly import Rig
from torquerig.rig.parts import Body, Coupling, Gear, Ground
from torquerig.rig.terms import Spring
from torquerig.simulation import kernel
from torquerig.simulation.arrays import Outputs
from torquerig.simulation.inputs import Span, filled
from torquerig.simulation.kernel.work import work_for
from torquerig.simulation.lower import lower

RATE, SAMPLES = 20_000.0, 4000
NONE = Outputs(np.zeros(0, dtype=np.uint64), np.zeros(0, dtype=np.uint64))


def vibrating(*, ratio: float, efficiency: float, backlash: float = 0.0, smoothing: float = 0.02) -> Rig:
    """Return two masses between springs to the frame and a gear that its rest angle twists; nothing drives it."""
    tiny = 1e-9  # [N m s/rad]
    return Rig(
        (
            Ground(name="left"),
            Coupling(name="first", after="left", stiffness=300.0, damping=tiny, inertia=2e-3),
            Gear(name="gear", after="first", ratio=ratio, stiffness=4e3, damping=tiny, efficiency=efficiency,
                 backlash=backlash, rest_angle=0.03, output_inertia=5e-3, smoothing=smoothing),
            Coupling(name="last", after="gear", stiffness=900.0, damping=tiny),
            Body(name="wheel", after="last", inertia=3e-3),
        ),
        Run(), measured="last",
    )  # fmt: skip


def energies(rig: Rig) -> np.ndarray:
    """Return kinetic and elastic energy [J] at each sample of a vibration from equal angles and rest."""
    lowered = lower(rig, 0)
    terms = filled(rig, lowered, Span(settling=0, samples=SAMPLES, rate=RATE, seed=0))
    work, kept = work_for(terms), np.empty((0, SAMPLES))
    theta, omega = np.zeros(len(lowered.nodes) + 1), np.zeros(len(lowered.nodes) + 1)
    springs = [term for part in rig.parts for term in part.terms(rig) if isinstance(term, Spring)]
    found = []
    for sample in range(SAMPLES):
        kernel.integrate_part(theta, omega, work, terms, NONE, RATE, 0, 8, kept, slice(sample, sample + 1))
        twists = [theta[lowered.node(s.a)] / s.ratio - theta[lowered.node(s.b)] - s.rest for s in springs]
        elastic = [0.5 * s.stiffness * max(0.0, abs(x) - s.gap / 2) ** 2 for s, x in zip(springs, twists, strict=True)]
        found.append(sum(elastic) + 0.5 * float(lowered.inertia @ omega[:-1] ** 2))
    return np.array(found)


@pytest.mark.parametrize("smoothing", [0.02, 1.0], ids=["sharp", "wide smoothing"])
@pytest.mark.parametrize("backlash", [0.0, 0.02], ids=["no play", "play"])
@pytest.mark.parametrize(("ratio", "efficiency"), [(3.0, 0.9), (-3.0, 0.6), (0.4, 0.8)])
def test_a_vibration_about_standstill_never_gains_energy(
    ratio: float, efficiency: float, backlash: float, smoothing: float
) -> None:
    """The integrator adds less than 1e-7 of the first energy; a loss by the output's speed adds per cents."""
    course = energies(vibrating(ratio=ratio, efficiency=efficiency, backlash=backlash, smoothing=smoothing))
    assert np.diff(course).max() < 1e-7 * course[0]
    assert course[-1] < 0.9 * course[0]


def test_a_gear_without_loss_keeps_the_energy() -> None:
    course = energies(vibrating(ratio=3.0, efficiency=1.0))
    assert np.ptp(course) < 1e-4 * course[0]
