"""Schema of a torque sensor file: range, stiffness, errors and converter."""

from __future__ import annotations

from typing import Annotated

from torquerig.catalog.entry import UNKNOWN, Entry, Record, Whole
from torquerig.parameter import Estimate, Parameter


class Converter(Record):
    """The analog-to-digital converter behind the sensor."""

    range: Annotated[Estimate, Parameter("V", "largest voltage of either sign", above=0)]
    bits: Annotated[Estimate, Parameter("bit", "resolution over both signs", low=1), Whole]
    sample_rate: Annotated[Estimate, Parameter("Hz", "samples per second", above=0)]


class Sensor(Entry):
    """One torque sensor with its amplifier; FS is its measuring range."""

    range_torque: Annotated[Estimate, Parameter("N*m", "measuring range of either sign", above=0)]
    output_range: Annotated[Estimate, Parameter("V", "output at the end of the range", above=0)] = UNKNOWN
    sensitivity: Annotated[Estimate, Parameter("V/(N*m)", "output per torque", above=0)]
    overload: Annotated[Estimate, Parameter("1", "static limit as a share of FS", low=1)] = UNKNOWN

    bandwidth: Annotated[Estimate, Parameter("Hz", "-3 dB, second order", above=0)]
    noise: Annotated[Estimate, Parameter("V", "rms noise of the output", low=0)]
    gain_tolerance: Annotated[Estimate, Parameter("1", "relative error of the sensitivity", low=0, high=1)] = UNKNOWN
    nonlinearity_hysteresis: Annotated[Estimate, Parameter("1", "share of FS", low=0, high=1)] = UNKNOWN
    zero_drift: Annotated[Estimate, Parameter("1", "share of FS per 10 K", low=0, high=1)] = UNKNOWN
    gain_drift: Annotated[Estimate, Parameter("1", "relative, per 10 K", low=0, high=1)] = UNKNOWN
    bending_crosstalk: Annotated[Estimate, Parameter("1", "share of FS, once per turn", low=0, high=1)] = UNKNOWN

    stiffness: Annotated[Estimate, Parameter("N*m/rad", "torsional stiffness", above=0)]
    damping: Annotated[Estimate, Parameter("N*m*s/rad", "torsional damping", low=0)]
    inertia: Annotated[Estimate, Parameter("kg*m^2", "inertia of its output side", above=0)]

    adc: Converter | None = None
    price: Annotated[Estimate, Parameter("EUR", "price", low=0)] = UNKNOWN
