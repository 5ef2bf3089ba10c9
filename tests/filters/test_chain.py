"""The reference report's two chains against its Appendix A and the audit, and chains written in YAML."""

from math import pi
from pathlib import Path

import numpy as np
import pytest

from torquerig.document import parse_document
from torquerig.errors import InputError
from torquerig.filters.butterworth import ButterworthLowPass
from torquerig.filters.chains.chain_file import read_chains
from torquerig.filters.chains.filter_chain import report_filter_code_chain, report_filter_text_chain
from torquerig.filters.ideal_bandstop import IdealBandstop
from torquerig.filters.moving_mean import MovingMeanKept
from torquerig.filters.synchronous_average import SynchronousAverage
from torquerig.orders.kinematics.kinematic_lines import Kinematics
from torquerig.orders.kinematics.teeth import Planetary
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run

ROOT = Path(__file__).resolve().parents[2]
REPORT_MOTOR = Kinematics(pole_pairs=7, slots=12, ratio=5)
SPEED = 1000 * pi / 30
RATE = 25000.0


def recording(torque):
    channel = Channel(values=torque, quantity="torque", unit="V")
    return Recording(sample_rate=RATE, channels={"torque_V": channel}, run=Run(speed=SPEED, gear_ratio=5))


def test_the_twenty_bands_of_appendix_a():
    # code lines 26-72: remove, 2 remove, 3 remove, 4 remove of each family, +-extra; report audit B4 for the slips
    rps, poles, magnets, gear, extra = 1000 / 60, 12, 14, 5, 0.5
    fundamentals = [rps * poles / 2, poles * magnets / 2 * rps / gear, rps, rps / gear, rps * magnets / 2]
    expected = [(k * f - extra, k * f + extra) for f in fundamentals for k in (1, 2, 3, 4)]
    (stage,) = report_filter_code_chain(REPORT_MOTOR).stages
    assert np.array(stage.bands(SPEED)) == pytest.approx(np.array(expected), rel=1e-12)


def test_the_report_filter_keeps_the_mean_and_cuts_its_lines():
    at = np.arange(150_000) / RATE  # 6 s: every line of the motor at 1000 rpm stands on a bin
    lines = sum(np.sin(2 * pi * line.frequency(SPEED) * at) for line in report_filter_code_chain(REPORT_MOTOR).lines)
    kept = 2.5 + 0.5 * np.sin(2 * pi * 57 * at)
    answer = report_filter_code_chain(REPORT_MOTOR).apply(recording(kept + lines)).torque()
    assert answer.mean() == pytest.approx(2.5, abs=1e-12)
    # a phase of 42 000 rad is rounded to 4e-12, in 20 lines
    assert answer == pytest.approx(kept, abs=1e-10)


@pytest.mark.parametrize(
    ("frequency", "gain"),
    [(10 / 3, 0.97), (20 / 3, 0.89), (10.0, 0.76), (40 / 3, 0.59), (50 / 3, 0.41)],
)
def test_the_text_of_the_report_puts_the_shaft_lines_back(frequency, gain):
    # report audit B3, two digits printed
    at = np.arange(30 * 7500) / RATE  # whole periods of every one of them
    (stage,) = report_filter_text_chain(REPORT_MOTOR).stages
    answer = stage.apply(recording(np.sin(2 * pi * frequency * at))).torque()
    inner = slice(5 * 7500, 25 * 7500)
    measured = abs(2 * np.mean(answer[inner] * np.exp(-2j * pi * frequency * at[inner])))
    transfer = np.sin(pi * frequency * 1000 / RATE) / (1000 * np.sin(pi * frequency / RATE))
    # the shorter mean at both ends leaks from 1000 of 225 000 samples into the middle
    assert measured == pytest.approx(transfer, abs=2e-3)
    assert transfer == pytest.approx(gain, abs=0.006)


def test_the_shipped_chains_hold_the_report_filters():
    chains = read_chains(ROOT / "scenarios" / "filters.yaml", kinematics=REPORT_MOTOR)
    assert list(chains) == [
        "none", "report_filter_code", "report_filter_text", "low_pass_20Hz", "order_lines", "order_lines_low_pass",
        "order_lines_inverse",
    ]  # fmt: skip
    assert chains["order_lines_inverse"].left_out[-1] == "load_inverse: no model of the rig is known here"
    assert chains["report_filter_code"] == report_filter_code_chain(REPORT_MOTOR)
    assert chains["report_filter_text"] == report_filter_text_chain(REPORT_MOTOR)
    assert chains["low_pass_20Hz"].stages == (ButterworthLowPass(cutoff=20.0, order=4),)
    assert chains["order_lines"].left_out == ("gear_mesh: tooth counts unknown",)


def test_the_shipped_chains_follow_the_drive():
    geared = Kinematics(pole_pairs=5, slots=12, ratio=5, teeth=(Planetary(21, 84, 3),))
    chain = read_chains(ROOT / "scenarios" / "filters.yaml", kinematics=geared)["order_lines"]
    assert not chain.left_out
    orders = {line.motor_order for line in chain.lines}
    assert {5.0, 60.0, 30.0, 12.0, 10.0} <= orders
    assert any(abs(order - 16.8) < 1e-12 for order in orders)


def test_no_filter_gives_the_recording_back():
    source = recording(np.arange(10.0))
    chains = read_chains(ROOT / "scenarios" / "filters.yaml", kinematics=REPORT_MOTOR)
    assert chains["none"].apply(source) is source


def test_every_shipped_chain_keeps_mean_and_length():
    values = 2.0 + 0.1 * np.random.default_rng(0).normal(size=100_000)
    for chain in read_chains(ROOT / "scenarios" / "filters.yaml", kinematics=REPORT_MOTOR).values():
        answer = chain.apply(recording(values)).torque()
        assert answer.size == values.size
        # a low-pass moves the mean by what it makes of the ends only
        assert answer.mean() == pytest.approx(values.mean(), abs=1e-3), chain.name


def test_harmonics_may_be_a_range_a_number_or_a_list():
    text = "filters: {a: [{type: ideal_bandstop, lines: {motor: 2..3, shaft: 1, electrical: [1, 4]}}]}"
    chain = read_chains(parse_document(text, Path("f.yaml")), kinematics=REPORT_MOTOR)["a"]
    assert [line.motor_order for line in chain.lines] == pytest.approx([2, 3, 0.2, 7, 28])


def test_stages_nest():
    text = "filters: {a: [{type: moving_mean_kept, samples: 100, around: [{type: ideal_bandstop, lines: {motor: 1}}]}]}"
    chain = read_chains(parse_document(text, Path("f.yaml")), kinematics=REPORT_MOTOR)["a"]
    (kept,) = chain.stages
    assert isinstance(kept, MovingMeanKept)
    assert isinstance(kept.around[0], IdealBandstop)
    assert len(chain.lines) == 1


STAGES = """
filters:
  a:
    - {type: hampel}
    - {type: notch_bank, lines: {motor: 1..2}, half_width: 0.3 Hz}
    - {type: notch_bank, lines: {motor: 1..2}, causal: true}
    - {type: order_bandstop, lines: {shaft: 1..4}, half_width: 0.1 1/rev}
    - {type: vold_kalman, lines: {shaft: 1..4}}
    - {type: weighted_lines, lines: {electrical: 1..4}, block: 20 s}
    - {type: adaptive_canceller, lines: {motor: 1..4}, half_width: 0.2 Hz}
    - {type: comb, lines: {shaft: 1}, periods: 3}
    - {type: comb, lines: {shaft: 1}, periods: 3, causal: true}
    - {type: synchronous_average, lines: {motor: 1..4}}
    - {type: butterworth_low_pass, cutoff: 50 Hz, causal: true}
    - {type: fir_low_pass, cutoff: 50 Hz, transition: 20 Hz}
    - {type: fir_low_pass, cutoff: 50 Hz, transition: 20 Hz, causal: true}
"""


@pytest.mark.long
def test_every_stage_can_be_written_keeps_a_constant_and_says_its_reach():
    chain = read_chains(parse_document(STAGES, Path("f.yaml")), kinematics=REPORT_MOTOR)["a"]
    speed = Channel(values=np.full(100_000, SPEED), quantity="motor_speed", unit="rad/s")
    source = recording(np.full(100_000, 2.5)).with_channel("speed", speed)
    for stage in chain.stages:
        assert stage.apply(source).torque() == pytest.approx(2.5, abs=1e-6), stage
        # a mean turn is that of the whole recording: no block can know it
        assert isinstance(stage, SynchronousAverage) or stage.reach(source) > 0
    causal = [stage for stage in chain.stages if hasattr(stage, "delay")]
    assert len(causal) == 5
    assert all(stage.delay(source) > 0 for stage in causal)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("a:\n- type: ideal_bandstop\n  lines: {moter: 1..4}", r"f.yaml:4: .*'moter'; did you mean 'motor'"),
        ("a:\n- type: ideal_bandstp\n  lines: {motor: 1}", r"f.yaml:\d: .*did you mean 'ideal_bandstop'"),
        ("a:\n- type: ideal_bandstop\n  lines: {motor: 4..1}", r"f.yaml:4: .*motor: '4..1' names no harmonics"),
        ("a:\n- type: ideal_bandstop\n  lines: {motor: 1..4000}", r"f.yaml:4: .*names no harmonics"),
        ("a:\n- type: ideal_bandstop\n  lines: []", r"f.yaml:4: .*lines are named by cause"),
        ("a:\n- type: butterworth_low_pass\n  cutoff: 20", r"f.yaml:4: .*20 has no unit; write '20 Hz'"),
        ("a:\n- type: butterworth_low_pass\n  cutoff: 20 s", r"f.yaml:4: .*'20 s' is a time"),
        ("a:\n- type: butterworth_low_pass\n  cutoff: -3 Hz", r"f.yaml:4: .*more than 0"),
        ("a:\n- type: butterworth_low_pass\n  cutof: 20 Hz", r"f.yaml:4: .*unknown key; did you mean 'cutoff'"),
        ("a:\n- type: harmonic_regression", r"f.yaml:3: .*'lines' is missing"),
        ("a:\n- 3", r"f.yaml:3: .*3 is no stage"),
        ("a: 3", r"f.yaml:2: filters.a: "),
    ],
)
def test_what_is_written_wrongly_is_named_with_its_line(text, sentence):
    document = parse_document("filters:\n  " + text.replace("\n", "\n  "), Path("f.yaml"))
    with pytest.raises(InputError, match=sentence):
        read_chains(document, kinematics=REPORT_MOTOR)


def test_a_file_without_filters_says_so():
    with pytest.raises(InputError, match="the key 'filters' is missing"):
        read_chains(parse_document("filter: {}", Path("f.yaml")), kinematics=REPORT_MOTOR)


def test_the_old_name_of_weighted_lines_is_read_with_a_notice(capsys):
    made = [
        read_chains(
            parse_document(f"filters:\n  one:\n    - {{type: {name}, lines: {{motor: 1..4}}}}\n", Path("filters.yaml")),
            kinematics=REPORT_MOTOR,
        )
        for name in ("weighted_lines", "weighed_lines")
    ]
    assert made[0] == made[1]
    assert capsys.readouterr().err.count("weighed_lines") == 1
