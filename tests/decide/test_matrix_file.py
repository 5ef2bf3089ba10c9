"""One's own matrix from YAML: what a cell may be, and what a broken file says."""

from pathlib import Path

import pytest

from torquerig.decide.matrix_io.matrix_file import matrix_from, read_matrix
from torquerig.document import parse_document
from torquerig.errors import InputError, UnknownNameError

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
    assert (case.baseline, case.profile.p_max, case.seed) == ("present drive", 5, 1)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        (
            "weight: 0.5",
            "weight: -0.5",
            r":\d+: criteria.ripple at the sensor.weight: the weight -0.5 must be at least 0",
        ),
        ("[[0, 5]", "[[0, 7]", "criteria.ripple at the sensor.points: 7 points are outside the scale 1..5; rescale"),
        ("[0.02, 4]", "[0.02, 0.5]", "criteria.ripple at the sensor.points: the value function is not monotone"),
        ("points: [[300, 5], [1500, 1]]", "points: [[1500, 1], [300, 5]]", "criteria.price.points: .*must ascend"),
        ("baseline: present drive", "baseline: servo B", "baseline: .* is not in the matrix; did you mean 'servo A'"),
        ("    price: 400", "    prise: 400", "induction motor B.prise: unknown criterion; did you mean 'price'"),
        ("    price: 400", "    price: 400 N*m", "induction motor B.price: .*is a torque; a price is wanted"),
        ("    price: 400", "    price: cheap", r"price: .*or write a bare number \[EUR\], \[low, high\] or \?"),
        ("    price: 400", "    price: [400]", "price: an interval has two ends"),
        ("    price: 400", "    price: [500, 400]", "price: the interval 500..400 must run upwards"),
        ("    price: 400", "    price: {valu: 400}", "price.valu: unknown key; did you mean 'value'"),
        ("    servo drive: no", "    servo drive: perhaps", "servo drive: 'perhaps' is no answer"),
        ("  servo A:", "  present drive:", "the key 'present drive' is already in line"),
        ("better: band", "better: bend", "criteria.rotor inertia.better: 'bend' is unknown; did you mean 'band'"),
        ("weight: 0.5", "weight: heavy", "criteria.ripple at the sensor.weight: 'heavy' is no number; write one"),
        ("  servo A:\n", '  "":\n', "alternatives.: a name is empty"),
        ("    band: [0.2, 1.0]\n", "", "criteria.rotor inertia: band limits and better: band belong together"),
        (
            "requirement: {max: 10}",
            "requirement: {}",
            "criteria.peak torque at the sensor: a requirement needs a limit",
        ),
        ("scale: {min: 1, max: 5}", "scale: {min: 5, max: 1}", r"scale: .*must run upwards"),
        ("points: [[1, 1], [1.5, 4], [2, 5]]", "purpose: none", "criteria.speed reserve: it has a weight but no value"),
        ("seed: 1 ", "draws: 0 ", "draws: 0 Monte Carlo samples are too few"),
        (
            "uncertainty: {scores: 0.5, weights: 0.25}",
            "uncertainty: {weights: 2} ",
            "uncertainty: the uncertainty of weights, 2, must lie between 0 and 1",
        ),
        (
            "uncertainty: {scores: 0.5, weights: 0.25}",
            "uncertainty: {scores: -1} ",
            "uncertainty: the uncertainty of scores, -1 points, must be",
        ),
        ("seed: 1 ", "cost: {criterion: prise, permissible: 9} ", "unknown criterion 'prise'; did you mean 'price'"),
        ("seed: 1 ", "cost: {criterion: price, permissible: 0} ", "cost.permissible: the permissible cost 0 must be"),
        ("seed: 1 ", "motors: {servo B: HDS6A-0104A} ", "motors.servo B: unknown alternative; did you mean 'servo A'"),
        (
            "    price: 400",
            "    price: {value: 400, by_hand: {points: 3}}",
            "price: a cell set by hand needs",
        ),
        ("    price: 400", "    price: {by_hand: {reason: x}}", "price: a cell set by hand needs|with either value or"),
        (
            "    price: 400",
            "    price: {by_hand: {points: 9, reason: x}}",
            "price.by_hand.points: 9 points are outside the scale 1..5",
        ),
        (
            "    unit: EUR\n",
            "    unit: EUR\n    catalog: price\n",
            "criteria.price.catalog: no alternative has a motor; add motors",
        ),
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


def with_motor(criterion):
    text = FILE.read_text(encoding="utf-8").replace("seed: 1 ", "motors: {servo A: HDS6A-0104A} ", 1)
    text = text.replace("  price:\n    unit: EUR\n", f"{criterion}  price:\n    unit: EUR\n", 1)
    return matrix_from(parse_document(text, FILE))


def test_a_cell_from_the_catalog_keeps_unit_interval_evidence_and_source():
    case = with_motor("  rated torque:\n    unit: N*cm\n    catalog: rated_torque\n")
    cell = case.matrix.cell("servo A", "rated torque")
    (origin,) = cell.origins
    assert origin.name == cell.fact == "rated torque of HDS6A-0104A"
    assert origin.evidence
    assert origin.source == cell.source != ""
    assert "N*cm" in origin.shown
    assert case.matrix.cell("present drive", "rated torque").unknown


@pytest.mark.parametrize(
    ("criterion", "said"),
    [
        ("  torque:\n    unit: N*m\n    catalog: rated_torqe\n", "torque.catalog: .*or 'rated_torque'"),
        ("  torque:\n    unit: kg\n    catalog: rated_torque\n", "torque.unit: rated_torque of a motor is in 'N[*]m'"),
    ],
)
def test_a_catalog_key_that_is_not_there_is_one_sentence(criterion, said):
    with pytest.raises(InputError, match=said):
        with_motor(criterion)


def test_an_unknown_motor_is_one_sentence_with_its_place():
    with pytest.raises(UnknownNameError, match=r":\d+: motors.servo A: there is no motor 'HDS6A-0104B' in the catalog"):
        edited("seed: 1 ", "motors: {servo A: HDS6A-0104B} ")


def test_what_was_set_by_hand_counts_and_keeps_what_it_replaced():
    case = edited("    price: 400", "    price: {value: 400, by_hand: {value: 350, reason: quoted by phone}}")
    cell = case.matrix.cell("induction motor B", "price")
    assert (cell.bounds, cell.value, cell.shown()) == ((350, 350), 400, "350 (by hand)")
    assert cell.by_hand.reason == "quoted by phone"


def test_keys_of_earlier_versions_are_read_with_one_notice(capsys):
    text = FILE.read_text(encoding="utf-8")
    old = text.replace("\nbaseline:", "\ndatum:").replace("\nuncertainty:", "\ndoubt:")
    old = old.replace("    requirement: {", "    demand: {")
    assert old.count("demand: {") > 1
    assert matrix_from(parse_document(old, FILE)) == matrix_from(parse_document(text, FILE))
    notice = capsys.readouterr().err
    assert notice.count("\n") == 1
    assert "'datum' is now 'baseline', 'doubt' is now 'uncertainty', 'demand' is now 'requirement'" in notice


def test_a_key_under_its_old_and_its_new_name_is_refused():
    with pytest.raises(InputError, match=r"\.yaml:19: datum: is the old name of 'baseline'; keep one of them"):
        edited("baseline: present drive", "datum: servo A\nbaseline: present drive")


def test_an_error_below_an_old_key_names_its_line():
    with pytest.raises(InputError, match=r"\.yaml:26: criteria.servo drive.requirement.minimum: unknown key"):
        edited("requirement: {min: 1}", "demand: {minimum: 1}")
