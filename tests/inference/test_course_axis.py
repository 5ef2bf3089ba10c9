"""Which quantity the residuals of mean torques follow."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.inference.drawn_runs import drawn_run, ramp, steady
from tests.inference.test_speed_courses import TOP, Known
from torquerig.inference.answer.course_axis import followed
from torquerig.inference.features.run_features import run_features


@pytest.mark.parametrize("axis", ["time", "speed"])
def test_a_bend_is_found_over_the_quantity_that_it_follows(axis):
    runs = [drawn_run(seed, speed=speed, noise=1e-3) for seed, speed in enumerate((ramp(1000), ramp(700), steady(900)))]
    time = np.linspace(0.0, 1.0, runs[0].torque.size)
    bent = [0.2 * np.maximum((run.speed / TOP if axis == "speed" else time) - 0.5, 0.0) for run in runs]
    known = Known(
        *(run_features(replace(run, torque=run.torque + own), []) for run, own in zip(runs, bent, strict=True))
    )
    assert followed(known.fit, known.data) == axis
