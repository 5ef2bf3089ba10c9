"""Runs of the wear rig, as the tests of a diagnosis record them."""

from tests.diagnosis.conftest import bench, by_hand, known_rig, record, three_runs, wear_rig

__all__ = ["bench", "by_hand", "known_rig", "record", "three_runs", "wear_rig"]
