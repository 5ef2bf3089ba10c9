"""Disturbances of the reading, one per file; the simulation and the diagnosis use the same class.

Motor and drive
    torque_ripple        measured lines of a shaft        cogging              magnets against teeth
    commutation_ripple   in proportion to the torque      eccentricity         teeth that pull unequally
    current_offset       order p, at any load             current_gain         order 2p, in proportion
    six_step_commutation 6p out of the phases (BLDC)      field_oriented_control  what FOC leaves (PMSM)
    hall_misplacement    unequal sectors: p, 2p, 3p       back_emf_harmonics   5th and 7th against sines, 6p
    dead_time            the inverter's pauses, 6p        phase_unbalance      one phase differs, 2p
    encoder_error        read by the speed loop           pwm_ripple           switching, nearly nothing
Shafts and gears
    gear_mesh            transmission error of a gear     tooth_mesh           the same out of its teeth
    belt_lines           belt, its teeth and pulleys      parallel_offset      parallel shafts with an offset, 1 and 2
    torsional_mode       an inertia on a spring           backlash             a gap in a gear
    misalignment         shafts at an angle, order 2      jaw_coupling         jaws and spider legs
    imbalance            gravity, order 1                 bearing_defect       impacts that ring
Load
    particle_load        hits and slow variation          blade_pass           a load pulse per blade
    stribeck_friction    dry friction by direction        quadratic_drag       windage
    lugre_friction       dry friction that sticks      granular_drag        by the angle, at any speed
    turbulent_load       by speed or its square, with turbulence
Sensor, cable and file
    sensor_bandwidth     a lower low-pass                 sensor_drift         a zero that moves
    sensor_nonlinearity  bent, or of wrong gain           sensor_hysteresis    lags when torque turns back
    bending_crosstalk    bending read as torque           mains_interference   hum of fixed frequency
    pwm_aliasing         switching, folded                signal_dropout       moments without signal
    clipping             saturation                       quantization         coarse codes
    noise_hump           a band of noise, no cause claimed
    reading_course       zero or gain that change, no cause claimed
    gain_ripple          lines in proportion to the torque, no cause claimed
    speed_course         torque that follows the speed, no cause claimed
    flicker_noise        1/f below a corner            logger_low_pass      the logger's filter, any order
"""

from __future__ import annotations

from importlib import import_module
from pkgutil import iter_modules
from typing import TYPE_CHECKING

from torquerig.errors import did_you_mean
from torquerig.extensions import extensions_of
from torquerig.rig.assembly import Part

if TYPE_CHECKING:
    from torquerig.mechanisms.back_emf_harmonics import BackEmfHarmonics as BackEmfHarmonics
    from torquerig.mechanisms.backlash import Backlash as Backlash
    from torquerig.mechanisms.bearing_defect import BearingDefect as BearingDefect
    from torquerig.mechanisms.belt_lines import BeltLines as BeltLines
    from torquerig.mechanisms.bending_crosstalk import BendingCrosstalk as BendingCrosstalk
    from torquerig.mechanisms.blade_pass import BladePass as BladePass
    from torquerig.mechanisms.clipping import Clipping as Clipping
    from torquerig.mechanisms.cogging import Cogging as Cogging
    from torquerig.mechanisms.commutation_ripple import CommutationRipple as CommutationRipple
    from torquerig.mechanisms.current_gain import CurrentGain as CurrentGain
    from torquerig.mechanisms.current_offset import CurrentOffset as CurrentOffset
    from torquerig.mechanisms.dead_time import DeadTime as DeadTime
    from torquerig.mechanisms.eccentricity import Eccentricity as Eccentricity
    from torquerig.mechanisms.encoder_error import EncoderError as EncoderError
    from torquerig.mechanisms.field_oriented_control import FieldOrientedControl as FieldOrientedControl
    from torquerig.mechanisms.flicker_noise import FlickerNoise as FlickerNoise
    from torquerig.mechanisms.gain_ripple import GainRipple as GainRipple
    from torquerig.mechanisms.gear_mesh import GearMesh as GearMesh
    from torquerig.mechanisms.granular_drag import GranularDrag as GranularDrag
    from torquerig.mechanisms.hall_misplacement import HallMisplacement as HallMisplacement
    from torquerig.mechanisms.imbalance import Imbalance as Imbalance
    from torquerig.mechanisms.jaw_coupling import JawCoupling as JawCoupling
    from torquerig.mechanisms.logger_low_pass import LoggerLowPass as LoggerLowPass
    from torquerig.mechanisms.lugre_friction import LugreFriction as LugreFriction
    from torquerig.mechanisms.mains_interference import MainsInterference as MainsInterference
    from torquerig.mechanisms.misalignment import Misalignment as Misalignment
    from torquerig.mechanisms.noise_hump import NoiseHump as NoiseHump
    from torquerig.mechanisms.parallel_offset import ParallelOffset as ParallelOffset
    from torquerig.mechanisms.particle_load import ParticleLoad as ParticleLoad
    from torquerig.mechanisms.phase_unbalance import PhaseUnbalance as PhaseUnbalance
    from torquerig.mechanisms.pwm_aliasing import PwmAliasing as PwmAliasing
    from torquerig.mechanisms.pwm_ripple import PwmRipple as PwmRipple
    from torquerig.mechanisms.quadratic_drag import QuadraticDrag as QuadraticDrag
    from torquerig.mechanisms.quantization import Quantization as Quantization
    from torquerig.mechanisms.reading_course import ReadingCourse as ReadingCourse
    from torquerig.mechanisms.sensor_bandwidth import SensorBandwidth as SensorBandwidth
    from torquerig.mechanisms.sensor_drift import SensorDrift as SensorDrift
    from torquerig.mechanisms.sensor_hysteresis import SensorHysteresis as SensorHysteresis
    from torquerig.mechanisms.sensor_nonlinearity import SensorNonlinearity as SensorNonlinearity
    from torquerig.mechanisms.signal_dropout import SignalDropout as SignalDropout
    from torquerig.mechanisms.six_step_commutation import SixStepCommutation as SixStepCommutation
    from torquerig.mechanisms.speed_course import SpeedCourse as SpeedCourse
    from torquerig.mechanisms.stribeck_friction import StribeckFriction as StribeckFriction
    from torquerig.mechanisms.tooth_mesh import ToothMesh as ToothMesh
    from torquerig.mechanisms.torque_ripple import TorqueRipple as TorqueRipple
    from torquerig.mechanisms.torsional_mode import TorsionalMode as TorsionalMode
    from torquerig.mechanisms.turbulent_load import TurbulentLoad as TurbulentLoad

    __all__: list[str]
else:  # whatever files there are, so that a mechanism goes with its file
    _modules = [import_module(f"{__name__}.{found.name}") for found in iter_modules(__path__)]
    _classes = {
        name: thing
        for module in _modules
        for name, thing in vars(module).items()
        if isinstance(thing, type) and issubclass(thing, Part) and thing.__module__ == module.__name__
    }
    globals().update(_classes)
    __all__ = list(_classes)


def extended() -> dict[str, type[Part]]:
    """Return the classes of all mechanisms by name: those of this folder, and those of other installed packages."""
    here = globals()  # a class can be missing here: blind trials hide mechanisms for a while
    built_in: dict[str, type[Part]] = {name: here[name] for name in here["__all__"] if name in here}
    return built_in | {cls.__name__: cls for cls in extensions_of("torquerig.mechanisms", Part).values()}


def __getattr__(name: str) -> type[Part]:
    """Return a mechanism that another installed package adds."""
    others = {} if name.startswith("_") else extended()
    if name not in others:
        raise AttributeError(f"there is no mechanism {name!r}; {did_you_mean(name, others)}")
    return others[name]
