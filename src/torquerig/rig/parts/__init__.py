"""What a rig is made of; one kind of part per file.

motor             rotor, losses, torque limit          speed_controller  sampled PI that drives a motor
gear              planetary or fixed-axis stage        belt              pulleys and a belt
gear_stage        what counts as a gear                coupling          spring between two shafts
torque_sensor     spring, amplifier, noise, converter  body              inertia with friction (wear part, flywheel)
encoder           counts of the motor angle            probe             torque, speed or angle anywhere
motor_phases      R, L, back-EMF and inverter          induction_drive   slip on mains or a plain inverter
"""

from torquerig.rig.parts.belt import BeltStage
from torquerig.rig.parts.body import Body
from torquerig.rig.parts.coupling import Coupling
from torquerig.rig.parts.encoder import MotorEncoder
from torquerig.rig.parts.gear import Gear
from torquerig.rig.parts.induction_drive import InductionDrive
from torquerig.rig.parts.motor import Motor
from torquerig.rig.parts.motor_phases import MotorPhases
from torquerig.rig.parts.probe import Probe
from torquerig.rig.parts.speed_controller import SpeedController
from torquerig.rig.parts.torque_sensor import TorqueSensor

__all__ = [
    "BeltStage",
    "Body",
    "Coupling",
    "Gear",
    "InductionDrive",
    "Motor",
    "MotorEncoder",
    "MotorPhases",
    "Probe",
    "SpeedController",
    "TorqueSensor",
]
