"""One's own matrix from YAML: what a cell may be, and what a broken file says."""

from pathlib import Path

import pytest

from torquerig.decide.matrix_file import matrix_from, read_matrix
from torquerig.document import parse_document
from torquerig.errors import InputError

FILE = Path(__file__).resolve().parents[2] / "scenarios" / "matrix_example.yaml"


def edited(old, new):
    text = FILE.read_text(encoding="utf-8")
    assert old in text
    return matrix_from(parse_document(text.replace(old, new, 1), FILE))


def test_the_shipped_example_reads_every_form_of_a_cell():
    case = read_matrix(FILE)
    cell = case.matrix.cell
    assert cell("present drive", "servo drive").bounds == (1, 1)
    assert cell("induction motor B", "servo drive").shown() == "no"
    assert cell("present drive", "rotor inertia").unknown
    assert cell("induction motor B", "peak torque at the sensor").unknown
    assert cell("servo A", "ripple at the sensor").bounds == (0.01, 0.03)
    assert cell("servo A", "rotor inertia").value == pytest.approx(0.28)  # 2.8e-5 kg*m^2 in kg*cm^2
    assert cell("induction motor B", "ripple at the sensor").value == pytest.approx(0.025)
    assert cell("present drive", "ripple at the sensor").source == "measured, run 12"
    assert (case.datum, case.profile.p_max, case.seed) == ("present drive", 5, 1)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("weight: 0.5", "weight: -0.5", r":\d+: criteria.ripple at the sensor: the weight -0.5 must be at least 0"),
        ("[[0, 5]", "[[0, 7]", "criteria.ripple at the sensor: 7 points are outside the scale 1..5"),
        ("[0.02, 4]", "[0.02, 0.5]", "criteria.ripple at the sensor: the value function is not monotone"),
        ("points: [[300, 5], [1500, 1]]", "points: [[1500, 1], [300, 5]]", "criteria.price: .*must ascend"),
        ("datum: present drive", "datum: servo B", "datum: .* is not in the matrix; did you mean 'servo A'"),
        ("    price: 400", "    prise: 400", "induction motor B.prise: unknown criterion; did you mean 'price'"),
        ("    price: 400", "    price: 400 N*m", "induction motor B.price: .*is a torque; a price is wanted"),
        ("    price: 400", "    price: cheap", r"price: .*or write a bare number \[EUR\], \[low, high\] or \?"),
        ("    price: 400", "    price: [400]", "price: an interval has two ends"),
        ("    price: 400", "    price: [500, 400]", "price: the interval 500..400 must run upwards"),
        ("    price: 400", "    price: {valu: 400}", "price.valu: unknown key; did you mean 'value'"),
        ("    servo drive: no", "    servo drive: perhaps", "servo drive: 'perhaps' is no answer"),
        ("  servo A:", "  present drive:", "the key 'present drive' stands already in line"),
        ("better: band", "better: bend", "criteria.rotor inertia.better: .*'bend'"),
        ("    band: [0.2, 1.0]\n", "", "criteria.rotor inertia: band limits and better: band belong together"),
        ("demand: {max: 10}", "demand: {}", "criteria.peak torque at the sensor: a demand needs a limit"),
        ("scale: {min: 1, max: 5}", "scale: {min: 5, max: 1}", r"scale: .*must run upwards"),
        ("points: [[1, 1], [1.5, 4], [2, 5]]", "purpose: none", "criteria.speed reserve: it has a weight but no value"),
        ("seed: 1 ", "draws: 0 ", "draws: 0 draws tell nothing"),
    ],
)
def test_a_broken_file_is_one_sentence_with_its_place(old, new, said):
    with pytest.raises(InputError, match=said) as raised:
        edited(old, new)
    assert str(raised.value).startswith(f"{FILE}:")
    assert "\n" not in str(raised.value)


def test_all_weights_zero_is_refused_with_its_place():
    text = FILE.read_text(encoding="utf-8")
    for weight in ("0.5", "0.2", "0.1"):
        text = text.replace(f"weight: {weight}\n", "weight: 0\n")
    with pytest.raises(InputError, match=r":\d+: criteria: all weights are 0"):
        matrix_from(parse_document(text, FILE))
