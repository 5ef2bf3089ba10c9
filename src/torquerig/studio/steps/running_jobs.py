"""The long work of each tab; it goes on while its page is loaded again."""

from __future__ import annotations

from weakref import WeakKeyDictionary

from torquerig.studio.jobs.job import Job
from torquerig.studio.session.tab_session import Session

_JOBS: WeakKeyDictionary[Session, dict[str, Job]] = WeakKeyDictionary()


def job_of(session: Session, kind: str) -> Job | None:
    """Return the last job of a kind, such as ``study``, of a tab; None where there is none."""
    return _JOBS.get(session, {}).get(kind)


def keep_job(session: Session, kind: str, job: Job) -> None:
    """Remember the last job of a kind of a tab."""
    _JOBS.setdefault(session, {})[kind] = job
