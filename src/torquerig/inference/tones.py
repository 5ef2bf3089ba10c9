"""A tone of fixed frequency in the signal, with the multiples that were found."""

from __future__ import annotations

from collections.abc import Iterator

from torquerig import mechanisms
from torquerig.inference.addition import DECADE, Addition, Reported, free_name
from torquerig.inference.context import Context, harmonics
from torquerig.inference.knobs import Knob
from torquerig.inference.places import Place

_HARMONICS = 6


def tone(
    context: Context, place: Place, *, name: str, mechanism: str, kind: str, log_odds: float
) -> Iterator[Addition]:
    """Yield the tone at a place, or nothing where no run shows it."""
    name = free_name(context.rig, name)
    multiples = context.multiples(place, most=_HARMONICS)

    def hum(amplitudes: tuple[float, ...]) -> mechanisms.MainsInterference:
        return mechanisms.MainsInterference(name=name, frequency=place.at, amplitudes=amplitudes)

    found = harmonics(
        context, multiples, unit=lambda multiple: hum((*(0.0,) * (multiple - 1), 1.0)),
        knob=lambda multiple: Knob(name, "amplitudes", DECADE, key=multiple - 1),
    )  # fmt: skip
    if 1 in found.medians:
        yield Addition(
            mechanism=mechanism, kind=kind, parts=(hum(found.row()),), knobs=tuple(found.knobs),
            starts=(tuple(found.start),), places=tuple(multiples.values()), log_odds=log_odds,
            label=f"{'hum' if mechanism else 'a tone'} at {place.at:.5g} Hz",
            fixed={"frequency_Hz": (place.at, context.resolution, "Hz")},
            reported=(Reported("amplitude_V", "amplitudes", "V", key=0),),
        )  # fmt: skip
