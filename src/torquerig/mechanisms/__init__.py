"""What can disturb the reading: one effect per file, the same class forwards (simulate) and backwards (diagnose).

torque_ripple      measured lines of a shaft        cogging             magnets against teeth
commutation_ripple in proportion to the torque      gear_mesh           transmission error of a gear
torsional_mode     an inertia on a spring           backlash            a gap in a gear
stribeck_friction  dry friction by direction        quadratic_drag      windage
particle_load      hits and slow variation          blade_pass          a load pulse per blade
"""

from torquerig.mechanisms.backlash import Backlash
from torquerig.mechanisms.blade_pass import BladePass
from torquerig.mechanisms.cogging import Cogging
from torquerig.mechanisms.commutation_ripple import CommutationRipple
from torquerig.mechanisms.gear_mesh import GearMesh
from torquerig.mechanisms.particle_load import ParticleLoad
from torquerig.mechanisms.quadratic_drag import QuadraticDrag
from torquerig.mechanisms.stribeck_friction import StribeckFriction
from torquerig.mechanisms.torque_ripple import TorqueRipple
from torquerig.mechanisms.torsional_mode import TorsionalMode

__all__ = [
    "Backlash",
    "BladePass",
    "Cogging",
    "CommutationRipple",
    "GearMesh",
    "ParticleLoad",
    "QuadraticDrag",
    "StribeckFriction",
    "TorqueRipple",
    "TorsionalMode",
]
