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


def cases() -> list[object]:
    """Return every fault; an angle in degrees that wraps is read as one that jumps."""
    read_as_jumps = pytest.mark.xfail(strict=True, reason="degrees that wrap are not unwrapped yet")
    return [
        pytest.param(each, id=name, marks=read_as_jumps if name == "wrapped_angle" else ())
        for name, each in BY_NAME.items()
    ]


@pytest.mark.parametrize("fault", cases())
def test_the_commands_name_it(fault: type[DrawnFault], capsys: pytest.CaptureFixture[str]) -> None:
    made = with_faults(mixed(base_signal()), [fault()], seed=1)
    write_synthetic(made.without_truth(), Path("x.csv"))
    for command in COMMANDS:
        said = said_by(command, capsys)
        if command in fault.named_by:
            assert re.search(fault.named_as, said), f"{command}: {said[-1500:]}"
        elif not fault.named_by:
            assert "suspicious" not in said, f"{command}: {said[-1500:]}"


def test_the_base_signal_has_no_fault(capsys: pytest.CaptureFixture[str]) -> None:
    write_synthetic(mixed(base_signal()).without_truth(), Path("x.csv"))
    for command in COMMANDS:
        said = said_by(command, capsys)
        assert "suspicious" not in said
        for fault in FAULTS:
            assert not fault.named_as or not re.search(fault.named_as, said), (command, fault.named_as)
