"""Time stamps of all forms give the seconds that lie between them, at once and one by one."""

from datetime import datetime, timedelta

import numpy as np
import pytest

from torquerig.recordings.files.text_tables import stamps
from torquerig.recordings.files.text_tables.stamp_parts import is_stamp
from torquerig.recordings.files.text_tables.stamps import Stamps, stamp_form

# over the end of a month, of February in a leap year, and of a year
STARTS = [datetime(2021, 5, 31, 23, 59, 59), datetime(2024, 2, 29, 23, 59, 58), datetime(2021, 12, 31, 23, 59, 59)]
FORMS = {
    "ISO": "%Y-%m-%dT%H:%M:%S.%f",
    "ISO with blank and zone": "%Y-%m-%d %H:%M:%S.%f+01:00",
    "slashes": "%Y/%m/%d %H:%M:%S.%f",
    "compact": "%Y%m%dT%H%M%S.%f",
    "day first": "%d.%m.%Y %H:%M:%S.%f",
    "day first, two digits": "%d.%m.%y %H:%M:%S,%f",
    "day first, slashes": "%d/%m/%Y %H:%M:%S.%f",
    "month first": "%m/%d/%Y %I:%M:%S.%f %p",
    "month by name": "%d-%b-%Y %H:%M:%S.%f",
    "clock": "%H:%M:%S.%f",
    "colon before milliseconds": "%d/%m/%Y %H:%M:%S:%f",
}


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("start", STARTS, ids=str)
def test_seconds_between_stamps(form: str, start: datetime, monkeypatch: pytest.MonkeyPatch) -> None:
    seconds = np.sort(np.random.default_rng(2).integers(0, 4_000_000, 60)) / 1e6
    seconds -= seconds[0]
    cells = [(start + timedelta(seconds=float(one))).strftime(FORMS[form]) for one in seconds]
    assert all(is_stamp(cell) for cell in cells)
    found = stamp_form(cells)
    assert found is not None
    converted = Stamps(found).seconds(cells)
    assert converted == pytest.approx(seconds, abs=1e-6)
    monkeypatch.setattr(stamps, "_converted_at_once", lambda *_: None)
    assert Stamps(found).seconds(cells) == pytest.approx(converted, abs=1e-12)


def test_a_zone_that_changes_with_the_season() -> None:
    cells = ["2021-10-31T02:59:59+02:00", "2021-10-31T02:00:00+01:00", "2021-10-31T02:00:01+01:00"]
    found = stamp_form(cells)
    assert found is not None
    assert Stamps(found).seconds(cells).tolist() == [0, 1, 2]


@pytest.mark.parametrize("cell", ["1.5", "12.05", "1,234", "10", "1.2.3", "v2.0", "a:b", "2021-13", "", "-1.#IND"])
def test_what_is_no_stamp(cell: str) -> None:
    assert not is_stamp(cell)


@pytest.mark.parametrize("cells", [["31.02.2021 10:00:00"], ["10:11", "10:12"], ["2021-05-12 10:00:00", "10:00:01"]])
def test_stamps_without_a_clear_meaning(cells: list[str]) -> None:
    assert stamp_form(cells) is None


def test_a_stamp_of_another_form_is_named() -> None:
    found = stamp_form(["2021-05-12 10:00:00", "2021-05-12 10:00:01"])
    assert found is not None
    with pytest.raises(ValueError, match="soon"):
        Stamps(found).seconds(["2021-05-12 10:00:02", "soon"])


def stamps_of(form: str, start: datetime, step: float, count: int) -> list[str]:
    return [(start + timedelta(seconds=step * number)).strftime(form) for number in range(count)]


@pytest.mark.parametrize(
    "form", ["%d/%m/%Y %H:%M:%S.%f", "%m/%d/%Y %H:%M:%S.%f", "%d-%m-%Y %H:%M:%S", "%m/%d/%y %H:%M:%S"]
)
@pytest.mark.parametrize("seen", [50, 1900])
def test_the_change_of_the_date_decides_the_order(form: str, seen: int) -> None:
    """Both orders are dates; the first cells show one date only, or two."""
    step = 0.5 if form.endswith("%f") else 1.0
    cells = stamps_of(form, datetime(2024, 3, 5, 23, 45), step, 3000)
    found = stamp_form(cells[:seen])
    assert found is not None
    stamps = Stamps(found)
    pieces = [stamps.seconds(cells[first : first + 700]) for first in range(0, 3000, 700)]
    assert np.diff(np.concatenate(pieces)) == pytest.approx(step)


@pytest.mark.parametrize("sign", [".", ":", ","])
@pytest.mark.parametrize("step", [5, 10, 100, 7])
def test_milliseconds_without_leading_zeros(sign: str, step: int) -> None:
    moments = [datetime(2024, 3, 5, 10, 11, 12) + timedelta(milliseconds=step * number) for number in range(400)]
    cells = [f"{one:%H:%M:%S}{sign}{one.microsecond // 1000}" for one in moments]
    found = stamp_form(cells)
    assert found is not None
    assert Stamps(found).seconds(cells) == pytest.approx(np.arange(400) * step / 1000)


@pytest.mark.parametrize("step", [5, 20, 250])
def test_fractions_without_trailing_zeros(step: int) -> None:
    moments = [datetime(2024, 3, 5, 10, 11, 12) + timedelta(milliseconds=step * number) for number in range(400)]
    cells = [f"{one:%H:%M:%S.%f}".rstrip("0").rstrip(".") for one in moments]
    found = stamp_form(cells)
    assert found is not None
    assert Stamps(found).seconds(cells) == pytest.approx(np.arange(400) * step / 1000)
