"""The sampling that times show: coarse and late stamps are accepted, lost and doubled samples never."""

from pathlib import Path

import numpy as np
import pytest

from torquerig.errors import RecordingError
from torquerig.recordings.files import open_stream, read_recording
from torquerig.recordings.files.blocks import Blocking, sound_blocks
from torquerig.recordings.files.timing import timing_of


def grid(samples: int, rate: float) -> np.ndarray:
    return np.arange(samples) / rate


@pytest.mark.parametrize("grain", [1e-3, 1e-4, 1 / 64])
@pytest.mark.parametrize("rate", [310.7, 800.0, 960.0, 2500.0, 4096.0])
def test_coarse_stamps(rate: float, grain: float) -> None:
    rng = np.random.default_rng(round(rate))
    for samples in (2000, 5000):
        times = np.floor((grid(samples, rate) + rng.uniform(0, 1)) / grain) * grain
        timing = timing_of(times, name="time")
        assert not timing.problem
        assert timing.rate == pytest.approx(rate, rel=timing.uncertainty)
        assert timing.uncertainty < 2.2 * grain * rate / samples  # both ends are off by up to one grain


def test_whole_milliseconds_at_2500_hz_are_noted() -> None:
    timing = timing_of(np.floor(grid(5000, 2500) * 1000 + 1e-9) / 1000, name="time")
    assert timing.rate == 2500
    assert "the times of time are in steps of 0.001 s, 2.5 samples; they fit an even 2500 Hz" in timing.note


@pytest.mark.parametrize("samples", [275, 430, 2000])
@pytest.mark.parametrize("rate", [50.0, 48.0, 20.0, 99.7])
@pytest.mark.parametrize("begin", [0.0, 0.5, 0.93])
def test_few_ticks_of_a_slow_clock(samples: int, rate: float, begin: float) -> None:
    times = np.floor(begin + grid(samples, rate) + 1e-9)
    if samples / rate < 5:
        return  # fewer than three whole ticks
    timing = timing_of(times, name="time")
    assert timing.problem == ""
    assert timing.rate == pytest.approx(rate, rel=min(timing.uncertainty, 0.01))
    lost = timing_of(np.delete(times, np.arange(samples // 2, samples // 2 + 3)), name="time")
    assert lost.problem


@pytest.mark.parametrize("grain", [None, 1e-3])
def test_lost_samples_are_never_hidden(grain: float | None) -> None:
    rng = np.random.default_rng(4)
    for lost in (1, 2, 3, 8, 20) * 6:
        samples = int(rng.integers(1000, 5000))
        places = rng.choice(np.arange(60, samples - 60), lost, replace=False)
        times = np.delete(grid(samples, 2500), places)
        times = times if grain is None else np.floor(times / grain + 1e-9) * grain
        timing = timing_of(times, name="time")
        assert timing.problem
        if grain is None:
            assert f"{lost} sample{'s' * (lost > 1)} lost in " in timing.problem
            assert str(int(places.min()) - 1) in timing.problem


@pytest.mark.parametrize("rate", [1000.0, 2500.0, 5000.0])
@pytest.mark.parametrize("samples", [500, 60_000])
def test_a_single_lost_or_doubled_sample_is_not_hidden_by_a_stated_rate(rate: float, samples: int) -> None:
    """Both shift the times by one sample, as a coarse stamp does; at that rate rounding makes no other step."""
    for places in ([samples // 3], [samples // 3, samples // 2]):
        lost = timing_of(np.delete(grid(samples, rate), places), name="time", stated=rate)
        assert f"{len(places)} sample{'s' * (len(places) > 1)} lost" in lost.problem
        doubled = np.insert(grid(samples, rate), places, grid(samples, rate)[places])
        assert "too close to the one before" in timing_of(doubled, name="time", stated=rate).problem


@pytest.mark.parametrize("lost", [2, 3, 20, 150])
@pytest.mark.parametrize("stated", [None, 1000.0])
def test_a_long_gap_is_not_taken_for_coarse_stamps(lost: int, stated: float | None) -> None:
    times = np.delete(grid(2000, 1000), np.arange(700, 700 + lost))
    assert f"{lost} samples lost in 1 gap" in timing_of(times, name="time", stated=stated).problem


@pytest.mark.parametrize(("rate", "samples"), [(960.0, 30), (999.9, 20_000), (990.0, 300)])
def test_few_other_steps_of_a_stated_rate_are_rounding(rate: float, samples: int) -> None:
    times = np.floor(grid(samples, rate) * 1000 + 1e-6) / 1000
    timing = timing_of(times, name="time", stated=rate)
    assert timing.problem == ""
    assert timing.rate == pytest.approx(rate, rel=timing.uncertainty)


def test_doubled_samples_are_counted() -> None:
    times = np.insert(grid(500, 1000), [40, 300], grid(500, 1000)[[40, 300]])
    problem = timing_of(times, name="time").problem
    assert "2 times (sample 41, 302) too close to the one before" in problem


@pytest.mark.parametrize("lateness", [0.1, 0.3, 1.0])
def test_late_stamps_of_a_computer(lateness: float) -> None:
    rng = np.random.default_rng(5)
    for _ in range(10):
        samples = int(rng.integers(2000, 9000))
        late = rng.exponential(lateness, samples)
        times = np.maximum.accumulate((np.arange(samples) + late) / 1000)
        timing = timing_of(times, name="time")
        assert not timing.problem
        assert timing.rate == pytest.approx(1000, rel=timing.uncertainty)
        assert "come back to an even" in timing.note
        without = np.delete(np.arange(samples), int(rng.integers(samples // 4, 3 * samples // 4)))
        assert timing_of(np.maximum.accumulate((without + late[1:]) / 1000), name="time").problem


@pytest.mark.parametrize(("lateness", "pause"), [(0.0, 50), (0.0, 250), (0.3, 50), (0.3, 250), (1.5, 0), (1.5, 50)])
def test_pauses_of_a_computer(lateness: float, pause: int) -> None:
    """The lost sample is in the middle: among the last ones the note says that it would not be seen."""
    rng = np.random.default_rng(6)
    for samples in (12_000, 30_000):
        arrived = np.arange(samples) + rng.exponential(1.0, samples) * lateness
        for start in rng.integers(0, samples - pause, 4):
            arrived[start : start + pause] = np.maximum(arrived[start : start + pause], start + pause)
        timing = timing_of(np.maximum.accumulate(arrived) / 1000, name="time")
        assert timing.problem == ""
        assert timing.rate == pytest.approx(1000, rel=timing.uncertainty)
        assert timing.uncertainty < 1e-3
        late = arrived - np.arange(samples)
        for place in rng.integers(samples // 20, samples - samples // 8, 4):
            kept = np.delete(np.arange(samples), place)
            assert timing_of(np.maximum.accumulate(kept + late[1:]) / 1000, name="time").problem, place


@pytest.mark.parametrize("seed", range(5))
def test_times_at_random_are_no_late_ones(seed: int) -> None:
    rng = np.random.default_rng(seed)
    assert timing_of(np.cumsum(rng.exponential(1e-3, 20_000)), name="time").problem
    assert timing_of(np.cumsum(rng.uniform(0.5e-3, 1.5e-3, 20_000)), name="time").problem


def test_one_late_stamp_is_noted() -> None:
    times = grid(500, 10)
    times[20] += 0.07
    timing = timing_of(times, name="time")
    assert (timing.rate, timing.problem) == (10, "")
    assert "1 time (sample 20) of time off an even 10 Hz, by up to 0.7 samples" in timing.note


def written(path: Path, times: np.ndarray, *, header: str = "time_s,torque_Nm", form: str = "{:.6f}") -> Path:
    rows = [f"{form.format(time)},{1 + 0.1 * np.sin(number):.4f}" for number, time in enumerate(times)]
    path.write_text(header + "\n" + "\n".join(rows) + "\n")
    return path


def test_coarse_stamps_in_blocks_and_at_once(tmp_path: Path) -> None:
    path = written(tmp_path / "run1.csv", np.floor(grid(4000, 2500) * 1000 + 1e-9) / 1000)
    assert read_recording(path).sample_rate == 2500
    stream = open_stream(path)
    assert stream.sample_rate == 2500
    assert any("in steps of 0.001 s" in note for note in stream.table.notes)
    assert sum(block.kept.stop - block.kept.start for block in sound_blocks(stream, Blocking(samples=1000))) == 4000
    lost = np.delete(np.floor(grid(4000, 2500) * 1000 + 1e-9) / 1000, [2500, 2501])
    written(path, lost)
    with pytest.raises(RecordingError, match="time_s is not evenly spaced"):
        read_recording(path)


@pytest.mark.parametrize(
    ("header", "factor"),
    [("Time [ms],Torque [Nm]", 1e3), ("time_min,torque_Nm", 1 / 60), ("Zeit (h),torque_Nm", 1 / 3600)],
)
def test_times_in_other_units(tmp_path: Path, header: str, factor: float) -> None:
    path = written(tmp_path / "run1.csv", grid(300, 2500) * factor, header=header, form="{:.12g}")
    assert read_recording(path).sample_rate == pytest.approx(2500, rel=1e-9)
    assert open_stream(path).sample_rate == pytest.approx(2500, rel=1e-9)


def test_a_stated_rate_gives_the_unit_of_the_times(tmp_path: Path) -> None:
    path = written(tmp_path / "run1.csv", np.arange(300) * 0.4, header="time,torque_Nm")
    with pytest.raises(RecordingError, match=r"steps of 0.4 are 2.5 Hz if they are seconds, and 2500 Hz if"):
        read_recording(path)
    path.with_suffix(".yaml").write_text("sample_rate_Hz: 2500\n")
    assert read_recording(path).sample_rate == 2500
    assert any("its numbers are milliseconds" in note for note in open_stream(path).table.notes)
    path.with_suffix(".yaml").write_text("sample_rate_Hz: 2400\n")
    with pytest.raises(RecordingError, match=r"states 2400 samples per second and the column time states 2.5"):
        read_recording(path)


@pytest.mark.parametrize(("first", "factor"), [(1_620_814_272_001, 1e3), (1_620_814_272_001_000, 1e6)])
def test_times_since_1970(tmp_path: Path, first: int, factor: float) -> None:
    path = written(
        tmp_path / "run1.csv", first + np.arange(300) * factor / 1000, header="time,torque_Nm", form="{:.0f}"
    )
    assert read_recording(path).sample_rate == pytest.approx(1000, rel=1e-6)


def test_a_rate_above_the_table_goes_before_coarse_stamps(tmp_path: Path) -> None:
    path = tmp_path / "run1.txt"
    path.write_text(
        "Samples per second: 960\nTime;Torque\ns;Nm\n"
        + "".join(f"{np.floor(number / 0.96) / 1000:.3f};1.{number % 10}\n" for number in range(30))
    )
    assert read_recording(path).sample_rate == 960
