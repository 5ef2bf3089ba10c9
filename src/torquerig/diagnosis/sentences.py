"""Explanations of findings: what the model lacks, how large it is, how much it explains, the best alternative."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from torquerig.diagnosis.outcome import Stated

_WHAT = {
    "gear_mesh": "a gear mesh of order {order_output:.0f} per output turn, with a transmission error of "
                 "{transmission_error_rad:.2g} rad",
    "commutation_ripple": "commutation torque ripple of {depth:.1%} of the motor torque, at motor order "
                          "{order_motor:.0f}",
    "torsional_mode": "a torsional mode at {frequency_Hz:.1f} Hz: a further inertia of {inertia_kgm2:.2g} kg m^2 on a "
                      "spring",
    "backlash": "backlash of about {gap_arcmin:.1f} arcmin in the gearbox",
    "stribeck_friction": "dry friction of {coulomb} at the loaded part",
    "bearing_defect": "a bearing defect: impacts at output order {order_output:.2f} that ring at "
                      "{ring_frequency_Hz:.0f} Hz",
    "mains_interference": "mains interference of {amplitude_V:.2g} V at {frequency_Hz:.3f} Hz",
    "sensor_bandwidth": "a lower bandwidth of the sensor's amplifier, with a cut-off at {cutoff_Hz:.0f} Hz",
    "sensor_drift": "a drift of the sensor zero by {span_V:.3g} V",
    "clipping": "clipping of the reading at {limit_V:.3g} V",
    "quantization": "quantization with a step of {step_V:.3g} V",
    "pwm_aliasing": "an aliased PWM tone of {amplitude_V:.2g} V at {frequency_Hz:.2f} Hz, constant at all speeds",
    "blade_pass": "load pulses of {amplitude_Nm:.3g} N m at output order {order_output:.0f}",
    "quadratic_drag": "quadratic drag of {coefficient_Nms2:.3g} N m s^2/rad^2",
    "signal_dropout": "signal dropouts of {duration_ms:.2g} ms, {rate_per_minute:.1f} per minute",
    "cogging": "cogging torque of {amplitude_Nm:.3g} N m at motor order {order_motor:.0f}",
}  # fmt: skip

MECHANISMS = tuple(_WHAT)

_OPEN_WIDTH = 20.0  # [1] ratio of a gap's limits from which on no width is stated
_CHATTER = "backlash in the gearbox; its width is open, because the teeth chatter without crossing the gap"


def explanation(
    mechanism: str, parameters: Mapping[str, Stated], *, share: float, rivals: Sequence[tuple[str, float]], gain: float
) -> str:
    """Return the sentences of a finding.

    Parameters
    ----------
    mechanism : str
    parameters : mapping of str to Stated
        Identified parameters by their names in the contract.
    share : float
        Share of the squared residual that the effect explains where it acts [1].
    rivals : sequence of (str, float)
        Alternative hypotheses with the fall of chi-square of each, best first.
    gain : float
        Fall of chi-square with the finding.
    """
    said = f"The model lacks {_what(mechanism, parameters)}. "
    said += f"It explains {100 * share:.0f} % of the squared residual where it acts."
    others = [(name, other) for name, other in rivals if name != mechanism and other > 0]
    if others and gain > 0:
        name, other = others[0]
        best = f"The best alternative, {name.replace('_', ' ')},"
        return f"{said} {best} lowers chi-square by {100 * other / gain:.0f} % as much."
    return f"{said} No other mechanism of the library lowers chi-square." if rivals else said


def _what(mechanism: str, parameters: Mapping[str, Stated]) -> str:
    if _has_open_width(parameters):
        return _CHATTER
    values = {name: stated.value for name, stated in parameters.items()}
    return _WHAT[mechanism].format(**values, coulomb=_coulomb(values))


def _coulomb(values: Mapping[str, float]) -> str:
    """Return dry friction as text, for each direction if it depends on it."""
    ends = {"": "", "_forward": " forward", "_backward": " backward"}
    sizes = [f"{values[f'coulomb_Nm{end}']:.2g} N m{way}" for end, way in ends.items() if f"coulomb_Nm{end}" in values]
    return " and ".join(sizes)


def _has_open_width(parameters: Mapping[str, Stated]) -> bool:
    gap = parameters.get("gap_arcmin")
    return gap is not None and gap.high > _OPEN_WIDTH * gap.low
