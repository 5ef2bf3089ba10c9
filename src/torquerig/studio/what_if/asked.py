"""Questions answered in the process that computes: its one engine keeps what the next question needs again."""

from __future__ import annotations

from pathlib import Path

from torquerig.document import parse_document
from torquerig.studio.what_if.answer import Simulated, Sized
from torquerig.studio.what_if.engine import WhatIf, stated_chain
from torquerig.studio.what_if.question import Question

_ENGINE = WhatIf()


def simulated(question: Question) -> Simulated:
    """Return :meth:`WhatIf.simulated`."""
    return _ENGINE.simulated(question)


def sized(question: Question) -> Sized:
    """Return :meth:`WhatIf.sized`."""
    return _ENGINE.sized(question)


def stated_question(path: Path, text: str, catalogs: tuple[Path, ...] = ()) -> Question:
    """Return the question of a scenario without a change, with its present filter chain."""
    chain = stated_chain(parse_document(text, path).data)
    return Question(path=path, text=text, chain=chain, catalogs=catalogs)
