"""A library of some mechanisms only."""

import pytest

from proof.library import CLASSES, library_of
from torquerig import mechanisms


def test_the_library_is_narrowed_and_put_back():
    assert all(hasattr(mechanisms, one) for one in CLASSES.values())
    with library_of({"gear_mesh"}):
        assert [name for name, one in CLASSES.items() if hasattr(mechanisms, one)] == ["gear_mesh"]
    assert all(hasattr(mechanisms, one) for one in CLASSES.values())
    with pytest.raises(ZeroDivisionError), library_of(()):
        1 / 0  # noqa: B018 (an error within)
    assert all(hasattr(mechanisms, one) for one in CLASSES.values())


class _Diagnosis:
    def __init__(self, findings, fit=None):
        self.findings, self.fit = findings, fit
