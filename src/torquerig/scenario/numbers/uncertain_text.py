"""Uncertain numbers written into a scenario file, as ``uncertain`` reads them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from torquerig.parameter import Estimate
from torquerig.rig.assembly import Rig
from torquerig.units import written_quantity

_DIGITS = 4  # of a standard deviation


def with_uncertainty(written: Any, known: Mapping[str, Estimate]) -> Any:
    """Return data of a part with the uncertainty of its numbers.

    Parameters
    ----------
    written
        Mappings and lists as YAML states them.
    known : mapping of str to Estimate
        By dotted path: ``mean_by_occupancy_percent.5``.
    """
    if "" in known:
        return _uncertain(written, known[""])
    below: dict[str, dict[str, Estimate]] = {}
    for path, estimate in known.items():
        key, _, inner = path.partition(".")
        below.setdefault(key, {})[inner] = estimate
    if isinstance(written, Mapping):
        return {key: with_uncertainty(value, below.get(_key(key), {})) for key, value in written.items()}
    if isinstance(written, list):
        return [with_uncertainty(value, below.get(str(key), {})) for key, value in enumerate(written)]
    return written


def by_part(known: Mapping[str, Estimate], rig: Rig) -> dict[str, dict[str, Estimate]]:
    """Return what is known of the numbers of each part by path, from ``part.path``; a name may have dots itself."""
    names = sorted((part.name for part in rig.parts), key=len, reverse=True)
    found: dict[str, dict[str, Estimate]] = {}
    for name, estimate in known.items():
        owner = next((one for one in names if name.startswith(f"{one}.")), None)
        if owner is not None:
            found.setdefault(owner, {})[name.removeprefix(f"{owner}.")] = estimate
    return found


def _uncertain(written: Any, known: Estimate) -> Any:
    if known.low is None or known.high is None:
        rel_sd = float(f"{known.rel_sd:.{_DIGITS}g}")
        return {"value": written, "rel_sd": rel_sd} if rel_sd else written
    is_bare = known.unit in ("1", "%")
    low, high = (end if is_bare else written_quantity(end, known.unit) for end in (known.low, known.high))
    return {"value": written, "low": low, "high": high}


def _key(key: Any) -> str:
    """Return the key of a mapping as a path has it: 5 for 5.0."""
    return f"{key:g}" if isinstance(key, float) else str(key)
