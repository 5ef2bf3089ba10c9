"""The parts of a rig, one kind per file.

motor             rotor, losses, torque limit          speed_controller  sampled PI that drives a motor
gear              planetary or fixed-axis stage        belt              pulleys and a belt
gear_stage        gear, belt or worm stages          coupling          spring between two shafts
torque_sensor     spring, amplifier, noise, converter  body              inertia with friction (wear part, flywheel)
encoder           counts of the motor angle            probe             torque, speed or angle anywhere
torque_controller torque mode, fed forward, replayed   replayed_torque   a measured torque on a shaft
imposed_motion    a shaft that turns as measured       slide             a mass in a line (kg, N, m)
link              spring in a line                     force_sensor      torque_sensor for motion in a line
speed_sensor      of any shaft                         acceleration_sensor  of any shaft
current_sensor    in the supply of a motor
motor_phases      R, L, back-EMF and inverter          induction_drive   slip on mains or a plain inverter
ground            a locked end                         worm_gear         worm and wheel, maybe self-locking
linear_drive      ball screw, rack or belt to a slide  tacho             pulses per turn of any shaft
reaction_torque_sensor  at the foot of a motor
"""

from torquerig.rig.parts.acceleration_sensor import AccelerationSensor
from torquerig.rig.parts.belt import BeltStage
from torquerig.rig.parts.body import Body
from torquerig.rig.parts.coupling import Coupling
from torquerig.rig.parts.current_sensor import CurrentSensor
from torquerig.rig.parts.encoder import MotorEncoder
from torquerig.rig.parts.force_sensor import ForceSensor
from torquerig.rig.parts.gear import Gear
from torquerig.rig.parts.ground import Ground
from torquerig.rig.parts.imposed_motion import ImposedMotion
from torquerig.rig.parts.induction_drive import InductionDrive
from torquerig.rig.parts.linear_drive import LinearDrive
from torquerig.rig.parts.link import Link
from torquerig.rig.parts.motor import Motor
from torquerig.rig.parts.motor_phases import MotorPhases
from torquerig.rig.parts.probe import Probe
from torquerig.rig.parts.reaction_torque_sensor import ReactionTorqueSensor
from torquerig.rig.parts.replayed_torque import ReplayedTorque
from torquerig.rig.parts.slide import Slide
from torquerig.rig.parts.speed_controller import SpeedController
from torquerig.rig.parts.speed_sensor import SpeedSensor
from torquerig.rig.parts.tacho import TachoSensor
from torquerig.rig.parts.torque_controller import TorqueController
from torquerig.rig.parts.torque_sensor import TorqueSensor
from torquerig.rig.parts.worm_gear import WormGear

__all__ = [
    "AccelerationSensor",
    "BeltStage",
    "Body",
    "Coupling",
    "CurrentSensor",
    "ForceSensor",
    "Gear",
    "Ground",
    "ImposedMotion",
    "InductionDrive",
    "LinearDrive",
    "Link",
    "Motor",
    "MotorEncoder",
    "MotorPhases",
    "Probe",
    "ReactionTorqueSensor",
    "ReplayedTorque",
    "Slide",
    "SpeedController",
    "SpeedSensor",
    "TachoSensor",
    "TorqueController",
    "TorqueSensor",
    "WormGear",
]
