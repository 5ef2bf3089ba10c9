"""How the tests are dealt to workers: by file, the heaviest files first, one thread of linear algebra in each."""

from __future__ import annotations

import os
from typing import Any

import pytest

from tests.chromium import chromium  # noqa: F401 (a fixture of all tests)

# before numpy is imported: the matrices are small, so further threads only wait, and beside a second worker they cost
# a third of the processor's time
os.environ |= dict.fromkeys(("OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1") | dict(os.environ)
# no test reads what an earlier version of the code has kept, or writes to the folder of the user; those of kept results
# name a folder
os.environ["TORQUERIG_CACHE"] = "none"

# one worker compiles the integrator with this file, while the other has files that need no compiled kernel
COMPILING, UNCOMPILED = "simulation/test_two_masses", "recordings/files/"
# each takes a worker for half a minute or more, so none of them may begin last
HEAVY = (
    "simulation/test_batch", "examples/", "cli/", "study/",
    "scenario/test_rigs_of_other_designs", "test_public_face",
)  # fmt: skip


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put the file that compiles first, then those without kernels and the heaviest; a file's own order stays."""
    ranks = ((COMPILING,), (UNCOMPILED,), HEAVY)

    def rank(item: pytest.Item) -> int:
        return next((place for place, parts in enumerate(ranks) if any(each in item.nodeid for each in parts)), 3)

    items.sort(key=rank)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Keep the tests of a file together: they share fixtures, and compile a kernel once instead of in each worker."""
    from xdist.scheduler import LoadFileScheduling

    if config.getvalue("dist") != "load":
        return None
    config.option.loadscopereorder = False  # by the number of tests, which says nothing about their time
    return LoadFileScheduling(config, log)
