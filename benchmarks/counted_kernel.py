"""How many floating-point operations the kernel does for one sample of a rig: counted, not estimated.

The kernel is plain Python that numba compiles. Here it runs uncompiled, with numbers that count what is done to them.
The program starts a process of its own for this, because numba reads NUMBA_DISABLE_JIT when it is imported.
Run: python benchmarks/counted_kernel.py
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections import Counter
from pathlib import Path

SAMPLES, BEFORE = 200, 400  # counted, after so many that are not
TALLY: Counter[str] = Counter()


class Counted:
    """A float that counts additions, products, divisions and comparisons."""

    __slots__ = ("value",)

    def __init__(self, value: float) -> None:
        self.value = float(value)

    def __float__(self) -> float:
        return self.value

    def __floor__(self) -> int:
        return int(self.value // 1)

    def __bool__(self) -> bool:
        return bool(self.value)

    def __neg__(self) -> Counted:
        return Counted(-self.value)

    def __abs__(self) -> Counted:
        return Counted(abs(self.value))


def _counting(name: str, kind: str, function) -> None:
    def forwards(self: Counted, other):
        TALLY[kind] += 1
        return function(self.value, float(other))

    def backwards(self: Counted, other):
        TALLY[kind] += 1
        return function(float(other), self.value)

    setattr(Counted, f"__{name}__", forwards)
    if kind != "comparisons":
        setattr(Counted, f"__r{name}__", backwards)


for _name, _kind, _function in (
    ("add", "additions", lambda a, b: Counted(a + b)), ("sub", "additions", lambda a, b: Counted(a - b)),
    ("mul", "products", lambda a, b: Counted(a * b)), ("truediv", "divisions", lambda a, b: Counted(a / b)),
    ("lt", "comparisons", lambda a, b: a < b), ("le", "comparisons", lambda a, b: a <= b),
    ("gt", "comparisons", lambda a, b: a > b), ("ge", "comparisons", lambda a, b: a >= b),
    ("eq", "comparisons", lambda a, b: a == b), ("ne", "comparisons", lambda a, b: a != b),
):  # fmt: skip
    _counting(_name, _kind, _function)
Counted.__hash__ = None  # type: ignore[assignment]


def counted_arrays(each):
    """Return arrays, or tuples of them, whose numbers count."""
    import numpy as np

    if isinstance(each, tuple):
        return type(each)(*(counted_arrays(one) for one in each))
    if not isinstance(each, np.ndarray) or each.dtype != np.float64:
        return each
    made = np.empty(each.shape, dtype=object)
    for place in np.ndindex(each.shape):
        made[place] = Counted(each[place])
    return made


def here() -> dict[str, float]:
    """Return the operations of one sample of the reference job, and its steps; needs NUMBA_DISABLE_JIT=1."""
    import numpy as np

    from torquerig.catalog.reading import Catalog
    from torquerig.document import read_document
    from torquerig.scenario.reading import read_scenario
    from torquerig.simulation.inputs import Span
    from torquerig.simulation.kernel.loop import advance
    from torquerig.simulation.kernel.work import work_for
    from torquerig.simulation.outputs import as_arrays
    from torquerig.simulation.ready import ready

    job = read_document(Path(__file__).resolve().parent / "reference_job.yaml")
    rig = read_scenario(job, Catalog(), seed=1).rig
    span = Span.of(duration=(BEFORE + SAMPLES) / 25_000, settling=0.0, rate=25_000.0, seed=1, wander=0.0)
    run = ready(rig, span, substeps=4)
    theta, omega = run.start()
    outputs = as_arrays(run.outputs)
    kept = np.empty((1, outputs.kind.size, span.samples))
    state = [counted_arrays(one) for one in (theta, omega, run.terms)]
    work = counted_arrays(work_for(run.terms))
    given = (state[0], state[1], state[2], outputs, span.rate, 0, run.steps, kept, work)
    advance(*given, 0, BEFORE, 0)
    TALLY.clear()
    advance(*given, BEFORE, BEFORE + SAMPLES, 0)
    return {
        **{kind: count / SAMPLES for kind, count in TALLY.items()},
        "steps": run.steps, "outputs": float(outputs.kind.size), "loads": float(len(run.terms.loads.on)),
    }  # fmt: skip


def counted() -> dict[str, float]:
    """Return the counts of :func:`here` from a process in which nothing is compiled."""
    run = subprocess.run(
        [sys.executable, __file__], env=os.environ | {"NUMBA_DISABLE_JIT": "1"}, check=True, capture_output=True,
        text=True,
    )  # fmt: skip
    return json.loads(run.stdout)


if __name__ == "__main__":
    print(json.dumps(here()))
