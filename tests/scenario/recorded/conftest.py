"""Fixtures that other folders have too."""

from tests.known_rigs import wear_rig  # noqa: F401
