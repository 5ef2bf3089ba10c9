"""Runs of the wear rig, as the tests of a diagnosis record them."""

from tests.known_rigs import record, wear_rig

__all__ = ["record", "wear_rig"]
