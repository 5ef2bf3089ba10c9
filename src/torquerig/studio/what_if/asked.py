"""Questions answered in the process that computes: its one engine keeps what the next question needs again.

The page's process imports this module for the names of its functions alone; the engine, with the compiled integrator,
is imported where the first question is answered.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.document import parse_document
from torquerig.studio.what_if.question import Question, stated_chain

if TYPE_CHECKING:
    from torquerig.studio.what_if.answer import Simulated, Sized
    from torquerig.studio.what_if.changeable import Changeable
    from torquerig.studio.what_if.engine import WhatIf
    from torquerig.studio.what_if.taken_over import Edit


def simulated(question: Question) -> Simulated:
    """Return :meth:`WhatIf.simulated`."""
    return _engine().simulated(question)


def sized(question: Question) -> Sized:
    """Return :meth:`WhatIf.sized`."""
    return _engine().sized(question)


def changeable_of(question: Question) -> Changeable:
    """Return what of the question's scenario can be changed; InputError where it cannot be used."""
    from torquerig.studio.what_if.changeable import changeable

    return changeable(question.text, question.path, _engine().catalog(question))


def edits_of(question: Question) -> tuple[Edit, ...]:
    """Return the edits that bring the question's changes into its scenario; InputError for bad ones."""
    from torquerig.studio.what_if.taken_over import taken_over

    return taken_over(question, _engine().catalog(question))


def stated_question(path: Path, text: str, catalogs: tuple[Path, ...] = ()) -> Question:
    """Return the question of a scenario without a change, with its present filter chain."""
    chain = stated_chain(parse_document(text, path).data)
    return Question(path=path, text=text, chain=chain, catalogs=catalogs)


@cache
def _engine() -> WhatIf:
    from torquerig.studio.what_if.engine import WhatIf

    return WhatIf()
