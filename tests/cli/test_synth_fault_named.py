"""Each fault that can be drawn is named by the commands that its registry entry states; the base signal has none."""

from __future__ import annotations

import re
from contextlib import suppress
from pathlib import Path

import pytest

from torquerig.cli import main
from torquerig.synthetic.base_signal import base_signal
from torquerig.synthetic.faults.drawn_fault import DrawnFault
from torquerig.synthetic.faults.registry import BY_NAME, FAULTS, with_faults
from torquerig.synthetic.mixture import mixed
from torquerig.synthetic.writing import write_synthetic

pytestmark = pytest.mark.long
COMMANDS = ("info", "filter", "ordermap")


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def said_by(command: str, capsys: pytest.CaptureFixture[str]) -> str:
    """Return what a command prints about x.csv, a refusal too, in one line."""
    with suppress(SystemExit):
        main((command, "x.csv"))
    return " ".join("".join(capsys.readouterr()).split())


VARIANTS: tuple[DrawnFault, ...] = (
    *(fault() for fault in FAULTS),
    BY_NAME["dropouts"](cutoff=0.0),
    BY_NAME["dropouts"](cutoff=1000.0, length=3e-3, level=0.3),
    BY_NAME["held_samples"](every=10),
    BY_NAME["late_stamps"](lateness=0.0),
    BY_NAME["late_stamps"](pause=50e-3),
    BY_NAME["late_stamps"](lateness=3e-4),
    BY_NAME["coarse_stamps"](grain=1e-2),
    BY_NAME["missing_samples"](rate=1 / 12),
    BY_NAME["missing_samples"](length=3),
    BY_NAME["duplicate_samples"](rate=1 / 12),
    BY_NAME["wrong_rate"](factor=0.5),
    BY_NAME["wrong_counts_per_turn"](factor=0.25),
    *(BY_NAME["wrapped_angle"](unit=unit) for unit in ("rad", "rev")),
    *(BY_NAME["wrapped_angle"](unit="count", bits=bits) for bits in (12, 16)),
)


@pytest.mark.parametrize("fault", VARIANTS, ids=lambda one: one.type)
def test_the_commands_name_it(fault: DrawnFault, capsys: pytest.CaptureFixture[str]) -> None:
    made = with_faults(mixed(base_signal()), [fault], seed=1)
    write_synthetic(made.without_truth(), Path("x.csv"))
    for command in COMMANDS if fault == type(fault)() else fault.named_by[:1]:
        said = said_by(command, capsys)
        if command in fault.named_by:
            assert re.search(fault.named_as, said), f"{command}: {said[-1500:]}"
        elif not fault.named_by:
            assert "suspicious" not in said, f"{command}: {said[-1500:]}"


def test_clipping_is_named_under_noise_where_the_signal_is_smooth(capsys: pytest.CaptureFixture[str]) -> None:
    mixture = base_signal()
    smooth = {name: one for name, one in mixture.components.items() if name != "sensor"}
    fault = BY_NAME["clipping"](noise=1e-3, share=0.05)
    made = with_faults(mixed(mixture.model_copy(update={"components": smooth})), [fault], seed=1)
    write_synthetic(made.without_truth(), Path("x.csv"))
    assert re.search(fault.named_as, said_by("info", capsys))


def test_the_base_signal_has_no_fault(capsys: pytest.CaptureFixture[str]) -> None:
    write_synthetic(mixed(base_signal()).without_truth(), Path("x.csv"))
    for command in COMMANDS:
        said = said_by(command, capsys)
        assert "suspicious" not in said
        for fault in FAULTS:
            assert not fault.named_as or not re.search(fault.named_as, said), (command, fault.named_as)
