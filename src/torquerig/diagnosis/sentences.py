"""What a finding says in one plain sentence: what was left out, and why this and not its rivals."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from torquerig.diagnosis.outcome import Stated

_WHAT = {
    "gear_mesh": "the teeth of the gearbox: a mesh of {order_output:.0f} teeth per output turn with a transmission "
                 "error of {transmission_error_rad:.2g} rad",
    "commutation_ripple": "torque ripple of the motor in proportion to its torque, {depth:.1%} at motor order "
                          "{order_motor:.0f}",
    "torsional_mode": "a further inertia of {inertia_kgm2:.2g} kg m^2 that rings at {frequency_Hz:.1f} Hz behind the "
                      "sensor",
    "backlash": "a gap of about {gap_arcmin:.1f} arcmin in the gearbox",
    "stribeck_friction": "dry friction at the loaded part",
    "bearing_defect": "impacts of a bearing, {order_output:.2f} per output turn, that ring at "
                      "{ring_frequency_Hz:.0f} Hz",
    "mains_interference": "hum of the mains at {frequency_Hz:.3f} Hz",
    "sensor_bandwidth": "an amplifier that cuts off at {cutoff_Hz:.0f} Hz",
    "sensor_drift": "a zero of the sensor that moves by {span_V:.3g} V",
    "clipping": "a reading that stops at {limit_V:.3g} V",
    "quantization": "codes {step_V:.3g} V apart",
    "pwm_aliasing": "a tone of fixed frequency, {frequency_Hz:.2f} Hz, above what the shafts pass on",
    "blade_pass": "pulses of the load, {order_output:.0f} per output turn, {amplitude_Nm:.3g} N m each",
    "quadratic_drag": "drag with the square of the speed, {coefficient_Nms2:.3g} N m s^2/rad^2",
    "signal_dropout": "moments without signal of {duration_ms:.2g} ms, {rate_per_minute:.1f} a minute",
    "cogging": "cogging of {amplitude_Nm:.3g} N m at motor order {order_motor:.0f}",
}  # fmt: skip

MECHANISMS = tuple(_WHAT)

_UNTOLD = 20.0  # ratio of a gap's limits from which on its width is not told at all
_CHATTER = "a gap in the gearbox whose width these runs do not tell: its flanks chatter and do not cross it"


def explanation(
    mechanism: str, parameters: Mapping[str, Stated], *, share: float, rivals: Sequence[tuple[str, float]], gain: float
) -> str:
    """Return the sentence; ``share`` is the part of the misfit at its places that the effect explains."""
    values = {name: stated.value for name, stated in parameters.items()}
    what = _CHATTER if _is_untold(parameters) else _WHAT[mechanism].format(**values)
    said = f"The model lacks {what}; it explains {share:.0%} of the misfit where it acts"
    others = [(name, other) for name, other in rivals if name != mechanism and other > 0]
    if others and gain > 0:
        name, other = others[0]
        said += f", where the nearest rival, {name.replace('_', ' ')}, lowers the misfit by {other / gain:.0%} as much"
    elif rivals:
        said += ", where no other mechanism of the library helps"
    return said + "."


def _is_untold(parameters: Mapping[str, Stated]) -> bool:
    gap = parameters.get("gap_arcmin")
    return gap is not None and gap.high > _UNTOLD * gap.low
