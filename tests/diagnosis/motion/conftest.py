"""Moved rigs and what a diagnosis says of them, as fixtures."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests import moved_rigs
from torquerig.diagnosis.motion.diagnose_motion import MotionOutcome
from torquerig.recordings.recording import Recording


@pytest.fixture(scope="session")
def carriage() -> Callable[[moved_rigs.Extra], Recording]:
    return moved_rigs.recorded


@pytest.fixture(scope="session")
def stated() -> str:
    return moved_rigs.CARRIAGE


@pytest.fixture(scope="session")
def diagnosed() -> Callable[..., MotionOutcome]:
    return moved_rigs.diagnosed
