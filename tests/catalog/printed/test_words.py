"""Figures of data sheets are taken apart into number, unit and words, in the spellings of makers."""

from math import pi

import pytest

from torquerig.catalog.printed.figure import read_figure
from torquerig.errors import UnitError

RPM = 2 * pi / 60
KE = [
    ("27.8 V/krpm line-to-line rms", 27.8 / (1000 * RPM), {"line", "rms"}),
    ("27.8 Vrms/krpm L-L", 27.8 / (1000 * RPM), {"line", "rms"}),
    ("27.8 Vrms/1000 min-1, phase-to-phase", 27.8 / (1000 * RPM), {"line", "rms"}),
    ("27.8 V/1000 rpm (rms, line to line)", 27.8 / (1000 * RPM), {"line", "rms"}),
    ("27.8 V/1000 r/min per phase peak", 27.8 / (1000 * RPM), {"phase", "peak"}),
    ("16 mV/rpm line-to-neutral rms", 0.016 / RPM, {"phase", "rms"}),
    ("39.3 Vpk/kRPM LL", 39.3 / (1000 * RPM), {"line", "peak"}),
    ("27.8 Vll,rms/Krpm", 27.8 / (1000 * RPM), {"line", "rms"}),
    ("27.8 V_LL_rms/kmin-1", 27.8 / (1000 * RPM), {"line", "rms"}),
    ("27.8 Vrms(L-L)/kRPM", 27.8 / (1000 * RPM), {"line", "rms"}),
    ("27.8 V/1000 min⁻¹ phase-phase eff", 27.8 / (1000 * RPM), {"line", "rms"}),
    ("0.265 V*s/rad line-to-line rms", 0.265, {"line", "rms"}),
    ("0.265 V/(rad/s) phase peak", 0.265, {"phase", "peak"}),
    ("0.265 V/rad/s", 0.265, set()),
]


@pytest.mark.parametrize(("text", "value", "words"), KE)
def test_voltage_constants_in_the_spellings_of_makers(text, value, words):
    figure = read_figure(text)
    assert figure.ratio("V", "rad/s", like="flux linkage") == pytest.approx((value, value))
    assert figure.words == words


@pytest.mark.parametrize(
    ("text", "value", "words"),
    [
        ("0.46 N*m/A rms", 0.46, {"rms"}),
        ("0.46 Nm/Arms", 0.46, {"rms"}),
        ("0.46 N·m/A (peak)", 0.46, {"peak"}),
        ("0.46 Nm/A_pk", 0.46, {"peak"}),
        ("0.46 N*m per rms ampere", 0.46, {"rms"}),
        ("65.1 oz-in/A", 65.1 * 7.061551814226044e-3, set()),
        ("4.07 lb-in/A rms", 4.07 * 0.1129848290276167, {"rms"}),
        ("55 mNm/A dc", 0.055, {"dc"}),
        ("0.46 Nm/A0-pk", 0.46, {"amplitude"}),
        ("0.46 Nm/A_eff", 0.46, {"rms"}),
    ],
)
def test_torque_constants_in_the_spellings_of_makers(text, value, words):
    figure = read_figure(text)
    assert figure.ratio("N*m", "A") == pytest.approx((value, value))
    assert figure.words == words


def test_speed_constants_tolerances_ranges_and_duties():
    assert read_figure("340 rpm/V dc").ratio("rad/s", "V") == pytest.approx((340 * RPM, 340 * RPM))
    assert read_figure("340 (r/min)/V").ratio("rad/s", "V")[0] == pytest.approx(340 * RPM)
    assert read_figure("0.79 ohms @25°C").celsius == 25
    assert read_figure("1.55 Ω/phase").quantity("ohm") == (1.55, 1.55)
    assert read_figure("1.55 Ω/phase").words == {"phase"}
    assert read_figure("340 min-1/V").ratio("rad/s", "V")[0] == pytest.approx(340 * RPM)
    assert read_figure("5.7 ohm line-to-line ± 10 %").quantity("ohm") == pytest.approx((5.13, 6.27))
    both = read_figure({"low": "5 ohm", "high": "6 ohm", "as": "line-to-line"})
    assert both.quantity("ohm") == (5.0, 6.0)
    assert both.words == {"line"}
    assert read_figure("1.8 N*m S3 40 %").duty == ("S3", 0.4)
    assert read_figure("1.8 N*m S3-40%").duty == ("S3", 0.4)
    assert read_figure("1.8 N*m (S1)").duty == ("S1", 1.0)
    assert read_figure("1.8 N*m (S1)").quantity("N*m") == (1.8, 1.8)
    assert read_figure("2 % of rated torque peak-to-peak").words == {"of rated", "peak-to-peak"}
    assert read_figure("2 % p-p").words == {"peak-to-peak"}
    assert read_figure("2 % zero-to-peak").words == {"amplitude"}


@pytest.mark.parametrize(
    ("written", "sentence"),
    [
        ("23,7 V/krpm", "has a decimal comma; write '23.7 V/krpm'"),
        (27.8, "27.8 is no figure with a unit"),
        ({"value": "1 ohm", "low": "1 ohm"}, "write either value, or low and high"),
        ({"value": "1 ohm", "per": "phase"}, "unknown key 'per'"),
        ({"value": "1 ohm", "as": "hot"}, "'hot' is not understood; known words are line-to-line"),
        ("27.8 V/krpm rms peak", "is both rms and peak"),
        ("5 ohm star delta", "is both star and delta"),
        ("1.8 N*m S3", "S3 needs its cyclic duration factor"),
        ("1.8 N*m S6 40 %", "ratings for S6 are not converted"),
        ("1.8 N*m ± 120 %", "tolerance of 100 % or more"),
    ],
)
def test_what_cannot_be_read_is_refused_with_the_remedy(written, sentence):
    with pytest.raises(UnitError, match=sentence.replace("(", r"\(")):
        read_figure(written)


def test_a_figure_of_another_kind_is_refused():
    with pytest.raises(UnitError, match="no unit of the kind V per rad/s"):
        read_figure("27.8 V line-to-line rms").ratio("V", "rad/s", like="flux linkage")
    with pytest.raises(UnitError, match="a voltage is wanted"):
        read_figure("27.8 A/krpm").ratio("V", "rad/s", like="flux linkage")
