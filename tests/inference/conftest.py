"""Fixtures that other folders have too."""

from tests.known_rigs import known_rig, record, wear_rig  # noqa: F401
