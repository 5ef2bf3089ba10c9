"""The process of a job: ``python -m torquerig.studio.jobs.child``; it ends when the studio does."""

from __future__ import annotations

import os
import pickle
import signal
import sys
import threading
from collections.abc import Callable
from importlib import import_module
from typing import Any

from torquerig.errors import TorquerigError

Report = Callable[..., None]
"""Called by the work: ``report(stage="reading")`` or ``report(done=3, total=12, name="HDS6A")``."""


def main() -> None:
    """Run the function that standard input names, and send progress and result as pickles on standard output.

    What the function itself prints goes to standard error.
    """
    out = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    pipe = os.fdopen(os.dup(0), "rb")
    module, name, arguments = pickle.load(pipe)  # noqa: S301 (from the studio that started this process)
    # workers that are forked close standard input: a thread that reads it would hold its lock in them for ever
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    threading.Thread(target=_end_with_the_studio, args=(pipe.fileno(),), daemon=True).start()
    lock = threading.Lock()

    def send(kind: str, content: Any) -> None:
        with lock:
            pickle.dump((kind, content), out)
            out.flush()

    def report(**what: Any) -> None:
        send("progress", what)

    try:
        result = getattr(import_module(module), name)(*arguments, report)
    except TorquerigError as error:
        send("failed", str(error))
    except OSError as error:
        send("failed", f"{error.filename or 'a file'}: {error.strerror or error}")
    except MemoryError:
        send("failed", "the memory of this machine is full; use fewer recordings or workers")
    except Exception as error:  # the page shows a sentence, and the traceback goes to the terminal of the studio
        sys.excepthook(*sys.exc_info())
        send("failed", f"{type(error).__name__}: {error}; this is a fault of torquerig, please report it")
    else:
        send("done", result)


def _end_with_the_studio(pipe: int) -> None:
    """End this process and those that it started when the studio closes the pipe: it was ended, or it died."""
    while os.read(pipe, 1):
        pass
    if os.name != "nt":
        os.killpg(os.getpgrp(), signal.SIGKILL)
    os._exit(1)


if __name__ == "__main__":
    main()
