"""The modules that propose hypotheses share the processes, but for those whose computations are used again."""

from __future__ import annotations

import os
from types import SimpleNamespace

import pytest

from torquerig.inference import additions
from torquerig.parallel import parallel_processes


@pytest.mark.parametrize("processes", [1, 2])
def test_what_keeps_proposes_in_the_first_process_and_all_in_their_order(processes, monkeypatch):
    def propose(context):
        yield context, os.getpid()

    keeping = {"b"}
    made = [SimpleNamespace(__name__=name, propose=propose, KEEPS=name in keeping) for name in "abc"]
    monkeypatch.setattr(additions, "modules", lambda: made)
    with parallel_processes(processes):
        found = [process for _, process in additions.proposals("context")]
    first = [process == os.getpid() for process in found]
    assert first == ([True] * 3 if processes == 1 else [False, True, False])
