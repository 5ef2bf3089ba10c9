import numpy as np
import pytest

from torquerig.filters.chains.filter_chain import Chain
from torquerig.filters.comb import Comb
from torquerig.filters.evaluation.order_shift import comb_teeth, empty_order_shifts, order_shifted
from torquerig.filters.evaluation.placebo import placebo
from torquerig.filters.synchronous_average import SynchronousAverage
from torquerig.orders.kinematics.kinematic_lines import KinematicLine
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

RATE, SECONDS, SPEED, RATIO = 1000.0, 40.0, 2 * np.pi * 10, 5.0  # the output shaft turns twice a second
AT = np.arange(int(RATE * SECONDS)) / RATE
ANGLE = SPEED * AT
LINES = tuple(KinematicLine("shaft", order, order / RATIO, float(order), "", "") for order in (1, 2, 3))


def recording(torque: np.ndarray) -> Recording:
    channels = {
        "torque_V": Channel(values=torque, quantity="torque", unit="V"),
        "angle": Channel(values=ANGLE, quantity="motor_angle", unit="rad"),
    }
    return Recording(sample_rate=RATE, channels=channels, run=Run(speed=SPEED, gear_ratio=RATIO))


def test_a_line_is_turned_on_by_so_many_orders_and_the_mean_stays():
    given = recording(1.5 + np.cos(3 / RATIO * ANGLE))
    moved = order_shifted(given, 0.5, angle=ANGLE, ratio=RATIO).torque()
    assert moved == pytest.approx(1.5 + np.cos(3.5 / RATIO * ANGLE), abs=1e-9)


@pytest.mark.parametrize(
    "stage", [Comb(lines=(LINES[0],), periods=5), SynchronousAverage(ratio=RATIO)], ids=["comb", "mean turn"]
)
def test_the_placebo_of_a_comb_cuts_noise_as_its_teeth_do_and_none_of_the_lines(stage):
    noise = np.random.default_rng(1).normal(size=AT.size)
    lines = sum(np.cos(line.motor_order * ANGLE) for line in LINES)
    made = placebo(Chain(name="comb", stages=(stage,)), recording(1.0 + lines + noise), known=LINES)
    assert made is not None
    # 1.5 of the variance of 2.5 are lines; teeth take 1 / 11, or 1 / 80 turns, of the noise
    share = 1 / 11 if isinstance(stage, Comb) else 1 / 80
    assert made.cut == pytest.approx(0.6 + 0.4 * share, abs=0.02)
    # at the ends a comb sees fewer periods, and its teeth reach the lines between them
    assert made.median == pytest.approx(0.4 * share, abs=0.03)
    assert made.beyond == pytest.approx(0.6, abs=0.03)


def test_every_known_line_falls_between_the_teeth():
    chain = Chain(name="comb", stages=(Comb(lines=(LINES[0],), periods=5),))
    assert comb_teeth(chain) == ((1.0, 1 / 11),)
    odd = KinematicLine("belt", 1, 0.08, 0.4, "", "")
    turns = empty_order_shifts(chain, known=(*LINES, odd))
    for by in turns:
        for line in (*LINES, odd):
            order = line.output_order + by
            assert abs(order - round(order)) >= 0.2 - 1e-9
    assert turns
    assert 0.6 not in turns
    assert empty_order_shifts(Chain(name="none", stages=()), known=LINES) == ()
