"""Old names of filter chains, stages and line families, which are still read."""

from __future__ import annotations

from torquerig.renamed import current_name

CHAINS = {"seed_code": "report_filter_code", "seed_text": "report_filter_text"}
STAGES = {"weighed_lines": "weighted_lines"}
FAMILIES = {"cogging_as_published": "cogging_per_pole", "unknown_as_published": "slots_times_pole_pairs"}


def current_chain(written: str) -> str:
    """Return the present name of a filter chain, with a notice on standard error for an old one."""
    return current_name(written, CHAINS, what="filter chain")


def current_stage(written: str) -> str:
    """Return the present name of a stage's type, with a notice on standard error for an old one."""
    return current_name(written, STAGES, what="filter stage")


def current_family(written: str) -> str:
    """Return the present name of a family of lines, with a notice on standard error for an old one."""
    return current_name(written, FAMILIES, what="line family")
