"""What a torque sensor will read, what disturbs it, which drive to buy, and which physics a model left out.

>>> import torquerig as tr
>>> rig = tr.read_scenario("wear_rig.yaml")
>>> rec = tr.simulate(rig, duration=2.0, seed=1)
>>> clean = tr.filter(rec, "order_lines")
>>> found = tr.order_lines(rec)

================== ================================================================================
``read_scenario``  a rig from its scenario file; ``scenario + tr.mechanisms.GearMesh(...)`` adds an effect
``read, write``    recordings from and to files
``simulate``       what the sensor of a rig records
``filter``         a recording through a filter chain
``order_lines``    the spectral lines of a recording and their causes
``compare``        motors, gearboxes and filters of a study, ranked
``diagnose``       which physics a scenario leaves out, by recordings of its rig
``size``           whether motor, gearbox and sensor are large enough
``duty``           how hot a motor becomes over a duty cycle
``modes``          modes of a rig and margins of its speed loop
``matrix``         elimination, Pugh and Kesselring of one's own matrix
``mechanisms``     the library of effects
================== ================================================================================
"""

from __future__ import annotations

from importlib import import_module

from torquerig.version import __version__ as __version__

__all__ = [
    "compare", "diagnose", "duty", "filter", "matrix", "mechanisms", "modes", "order_lines", "read", "read_scenario",
    "simulate", "size", "write",
]  # fmt: skip

_MODULES = {
    "compare": "comparison",
    "diagnose": "recording_diagnosis",
    "duty": "drive_duty",
    "filter": "filtered",
    "matrix": "decision_matrix",
    "modes": "rig_modes",
    "order_lines": "spectral_lines",
    "read": "recording_files",
    "read_scenario": "scenarios",
    "simulate": "simulated",
    "size": "drive_size",
    "write": "recording_files",
}

TYPE_CHECKING = False  # as in typing, whose import would take most of the time of this one
if TYPE_CHECKING:
    from typing import Any

    from torquerig import mechanisms as mechanisms
    from torquerig.api.comparison import compare as compare
    from torquerig.api.decision_matrix import matrix as matrix
    from torquerig.api.drive_duty import duty as duty
    from torquerig.api.drive_size import size as size
    from torquerig.api.filtered import filter as filter  # noqa: A004 (the public name)
    from torquerig.api.recording_diagnosis import diagnose as diagnose
    from torquerig.api.recording_files import read as read
    from torquerig.api.recording_files import write as write
    from torquerig.api.rig_modes import modes as modes
    from torquerig.api.scenarios import read_scenario as read_scenario
    from torquerig.api.simulated import simulate as simulate
    from torquerig.api.spectral_lines import order_lines as order_lines


def __getattr__(name: str) -> Any:
    """Import a public function when it is first used, so that ``import torquerig`` is fast."""
    if name == "mechanisms":
        return import_module("torquerig.mechanisms")
    if name not in _MODULES:
        raise AttributeError(f"module 'torquerig' has no attribute {name!r}; it has {', '.join(__all__)}")
    found = getattr(import_module(f"torquerig.api.{_MODULES[name]}"), name)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
