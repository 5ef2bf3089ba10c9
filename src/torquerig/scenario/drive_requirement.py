"""Speed and torque over time that a run requires of the motor, calculated without simulation."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from torquerig.errors import InputError
from torquerig.recordings.profiles.breakpoints import Breakpoints
from torquerig.recordings.profiles.tabulated import Tabulated
from torquerig.rig.assembly import Rig
from torquerig.rig.drive_train import DriveTrain, drive_train, driven_motor
from torquerig.rig.parts.induction_drive import InductionDrive

Floats = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class DriveRequirement:
    """Required speed and torque of a run, or of one cycle of it, in pieces within which both are linear.

    Parameters
    ----------
    duration : ndarray, shape (pieces,)
        [s]
    speed, torque : ndarray, shape (pieces, 2)
        Of the motor at start and end of each piece [rad/s], [N m].
    step : ndarray of bool, shape (pieces,)
        Pieces that are not in the profile: the drive at its torque limit after a step of the set-point.
    load : ndarray, shape (pieces, 2)
        The load that the profile states [N m]; not a number where the rig's own loads count.
    held : ndarray of bool, shape (pieces,)
        Pieces at rest in which the drive holds the stated load.
    late : tuple of str
        Steps that the drive cannot complete before the next piece begins, a sentence each.
    """

    duration: Floats
    speed: Floats
    torque: Floats
    step: NDArray[np.bool_]
    load: Floats
    held: NDArray[np.bool_]
    late: tuple[str, ...] = ()

    @property
    def start(self) -> Floats:
        """Start time of each piece [s], shape (pieces,)."""
        return np.concatenate([[0.0], np.cumsum(self.duration)[:-1]])

    @property
    def top_speed(self) -> float:
        """The largest speed in either direction [rad/s]."""
        return float(np.abs(self.speed).max())

    @property
    def rms_torque(self) -> float:
        """The root of the mean square of the torque [N m]; of a linear piece (a^2 + a b + b^2) / 3."""
        first, last = self.torque[:, 0], self.torque[:, 1]
        squares = (first**2 + first * last + last**2) / 3
        return float(np.sqrt(np.sum(self.duration * squares) / np.sum(self.duration)))

    def at_worst(self) -> tuple[float, float]:
        """Return the largest torque of the profile without steps [N m], and its time [s]."""
        torque = np.where(self.step[:, None], 0.0, np.abs(self.torque))
        row, end = np.unravel_index(int(np.argmax(torque)), torque.shape)
        return float(torque[row, end]), float(self.start[row] + end * self.duration[row])


def drive_requirement(rig: Rig, *, duration: float) -> DriveRequirement:
    """Return the required speed and torque of the motor, from inertias, loads, friction and gears, all rigid.

    A step of the set-point is performed at the drive's torque limit, within the following piece. Ripple, torsion of the
    shafts and overshoot of the speed loop are not included: the requirement does not depend on the controller.

    Parameters
    ----------
    duration : float
        Length of the recording [s]; a profile with a stated length counts once, as a cycle.

    Raises
    ------
    InputError
        When no motor of the rig has a speed to follow, or its run states none.
    """
    motor = driven_motor(rig)
    if motor is None or rig.run.speed is None:
        raise InputError("the rig has no motor with a speed; add a speed_controller "
                         "and a speed")  # fmt: skip
    train, course = drive_train(rig, rig.node(motor.name)), rig.run.speed_profile()
    corners = _split_at_rest(course.breakpoints(top=rig.run.speed, duration=duration))
    pieces = _Pieces(train=train, limit=motor.torque_limit)
    again = isinstance(course, Tabulated) and course.repeats != 1
    before = corners.speed[-1 if again else 0]
    for row in range(len(corners.time) - 1):
        span = corners.time[row + 1] - corners.time[row]
        if span <= 0:
            continue
        load = (None, None) if corners.load is None else (corners.load[row], corners.load[row + 1])
        held = corners.held is not None and corners.held[row] and corners.held[row + 1]
        pieces.add(span, (corners.speed[row], corners.speed[row + 1]), load, before, corners.time[row], held=held)
        before = corners.speed[row + 1]
    drive = next((one for one in rig.parts_of(InductionDrive) if one.motor == motor.name), None)
    return pieces.made() if drive is None else _behind_the_field(pieces.made(), drive)


def _behind_the_field(required: DriveRequirement, drive: InductionDrive) -> DriveRequirement:
    """Return the requirement at the shaft of an induction motor: slower than its field by the slip of each torque.

    The torque is that at the speed of the field; with the slip of a few per cent it changes by less.
    """
    slip = np.vectorize(drive.slip_speed, otypes=[float])(required.torque)
    return replace(required, speed=required.speed - slip)


class _Piece(NamedTuple):
    """One row of a requirement; ``load`` None where the rig's own loads count."""

    duration: float
    speed: tuple[float, float]
    torque: tuple[float, float]
    step: bool
    load: tuple[float | None, float | None]
    held: bool


class _Pieces:
    """Collects the pieces of a requirement."""

    def __init__(self, *, train: DriveTrain, limit: float) -> None:
        self.train, self.limit = train, limit
        self.rows: list[_Piece] = []
        self.late: list[str] = []

    def add(
        self, span: float, speed: tuple[float, float], load: tuple[float | None, float | None], before: float,
        at: float, *, held: bool,
    ) -> None:  # fmt: skip
        """Add one linear piece; where it does not start at the speed ``before``, add the step first."""
        slope = (speed[1] - speed[0]) / span
        if abs(speed[0] - before) > 1e-9 * max(1.0, abs(before)):
            taken = self._step(before, speed[0], load[0], at, span)
            span -= taken
            speed = (speed[0] + slope * taken, speed[1])
        if span > 0:
            way = np.sign(speed[0] + speed[1])
            pulls = zip(speed, load, strict=True)
            held = held and way == 0
            if held:
                torque = [self.train.holding_torque(pull or 0.0) for pull in load]
            else:
                torque = [self.train.torque(one, slope, load=pull, way=way) for one, pull in pulls]
            self.rows.append(_Piece(span, speed, (torque[0], torque[1]), False, load, held))

    def _step(self, before: float, after: float, load: float | None, at: float, span: float) -> float:
        """Add the drive at its limit from one speed to the other and return how long that takes [s]."""
        way = float(np.sign(after - before))
        steady = self.train.torque(0.5 * (before + after), 0.0, load=load, way=np.sign(before + after))
        available = self.limit - way * steady
        step = f"the step from {_rpm(before)} to {_rpm(after)} rpm of the motor at {at:g} s"
        if available <= 0:
            self.late.append(f"{step}: the load alone requires more than the drive's {self.limit:.3g} N*m")
            return 0.0
        needed = self.train.inertia * abs(after - before) / available
        if needed > span:
            self.late.append(
                f"{step}: it takes {needed:.3g} s at the drive's limit, and the next piece begins {span:.3g} s later"
            )
        needed = min(needed, span)
        pushed = way * self.limit
        self.rows.append(_Piece(needed, (before, after), (pushed, pushed), True, (load, load), False))
        return needed

    def made(self) -> DriveRequirement:
        duration, speed, torque, step, load, held = zip(*self.rows, strict=True)
        return DriveRequirement(
            duration=np.array(duration),
            speed=np.array(speed),
            torque=np.array(torque),
            step=np.array(step),
            load=np.array(load, dtype=np.float64),
            held=np.array(held),
            late=tuple(self.late),
        )


def _rpm(speed: float) -> str:
    return f"{speed * 30 / np.pi:.5g}"


def _split_at_rest(corners: Breakpoints) -> Breakpoints:
    """Return the same corners with a point at each zero of the speed, where friction and load change sign."""
    time, speed = list(corners.time), list(corners.speed)
    load = None if corners.load is None else list(corners.load)
    held = None if corners.held is None else list(corners.held)
    for row in reversed(range(len(time) - 1)):
        if speed[row] * speed[row + 1] < 0 and time[row + 1] > time[row]:
            share = speed[row] / (speed[row] - speed[row + 1])
            time.insert(row + 1, time[row] + share * (time[row + 1] - time[row]))
            speed.insert(row + 1, 0.0)
            if load is not None:
                load.insert(row + 1, load[row] + share * (load[row + 1] - load[row]))
            if held is not None:
                held.insert(row + 1, held[row] and held[row + 1])
    return Breakpoints(
        time=tuple(time), speed=tuple(speed), load=None if load is None else tuple(load),
        held=None if held is None else tuple(held),
    )  # fmt: skip
