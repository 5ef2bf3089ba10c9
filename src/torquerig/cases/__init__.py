"""Many independent cases, computed by many workers into one table that loses nothing.

A study is a table of cases and one function. This package knows nothing of rigs.

>>> from torquerig.cases.case import Case
>>> Case(number=0, values={"load": 0.5}, seed=1).values["load"]
0.5

================== ==================================================================================
``case``           a case, a column, the work function
``answers``        an answer to every case as they arrive; halves of blocks that were lost
``running``        a study run into its store: kept, resumed, stopped
``store``          rows in a folder; ``parts``: its Parquet files; ``folder_lock``: one writer at a time
``identity``       which study a store holds, computed with which code
``limits``         time and tries of a case, one thread a worker
``block``          blocks of cases, outcomes, and what an engine is
``this_process``   engine: here, one after the other
``this_machine``   engine: processes of this machine; ``worker``: one of them
``cluster``        engine: a Dask cluster; ``cluster_worker``: what runs there
================== ==================================================================================
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from torquerig.cases.answers import Answer, answers
from torquerig.cases.case import Case, Column, Failed, Work

if TYPE_CHECKING:
    from torquerig.cases.cluster import Cluster as Cluster
    from torquerig.cases.identity import Identity as Identity
    from torquerig.cases.identity import digest_of as digest_of
    from torquerig.cases.limits import Limits as Limits
    from torquerig.cases.running import Progress as Progress
    from torquerig.cases.running import StudyRun as StudyRun
    from torquerig.cases.running import StudyStopped as StudyStopped
    from torquerig.cases.running import run_cases as run_cases
    from torquerig.cases.store import read_rows as read_rows
    from torquerig.cases.this_machine import ThisMachine as ThisMachine
    from torquerig.cases.this_process import ThisProcess as ThisProcess

__all__ = [
    "Answer", "Case", "Cluster", "Column", "Failed", "Identity", "Limits", "Progress", "StudyRun", "StudyStopped",
    "ThisMachine", "ThisProcess", "Work", "answers", "digest_of", "read_rows", "run_cases",
]  # fmt: skip

_MODULES = {
    "Cluster": "cluster", "Identity": "identity", "Limits": "limits", "Progress": "running", "StudyRun": "running",
    "StudyStopped": "running", "ThisMachine": "this_machine", "ThisProcess": "this_process", "digest_of": "identity",
    "read_rows": "store", "run_cases": "running",
}  # fmt: skip


def __getattr__(name: str) -> Any:
    """Import a public name when it is first used: engines and stores take 0.1 s."""
    if name in _MODULES:
        return getattr(import_module(f"torquerig.cases.{_MODULES[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
