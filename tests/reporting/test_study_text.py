from torquerig.reporting.study.text import WIDTH, ranked_text, shares_text


def test_no_line_is_wider_than_the_terminal(runs, decided):
    lines = [*ranked_text(decided, most=99).splitlines(), *shares_text(runs).splitlines()]
    assert max(map(len, lines)) <= WIDTH


def test_the_present_combination_is_shown_even_far_down(decided):
    shown = ranked_text(decided, most=1).splitlines()
    first = decided.alternatives[decided.ranked()[0]]
    assert first.chain in shown[2]
    assert first.drive.candidate.name in shown[2]
    assert any("bldc-12n14p 5:1" in line and " none " in line and "*" in line for line in shown[2:])


def test_shares_say_what_was_not_simulated(runs):
    text = shares_text(runs)
    assert "0.4000  64.0 %" in text
    assert "GP-71M 20:1: needs 4000 rpm" in text
