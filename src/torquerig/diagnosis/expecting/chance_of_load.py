"""What chance gave a simulated load, taken out of its features: some seconds of hits may be a fifth too loud.

Two models that differ in a number of the load draw other hits. All bands then differ together, and hits add to lines or
take from them, which would count for one of the models. What was drawn is known, and what the linear twin makes of it:
the twin is a control variate, the mean stays that of the simulations, and their scatter goes (Glasserman 2003, Monte
Carlo Methods in Financial Engineering, section 4.1).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import fft

from torquerig.diagnosis.expecting.expectation import Expectation
from torquerig.diagnosis.looking.bands import bands, spectrum
from torquerig.diagnosis.looking.features import Features
from torquerig.diagnosis.looking.observed import Observed
from torquerig.diagnosis.looking.stretch_lines import shown_places
from torquerig.linear_twin.twin import Twin
from torquerig.rig.assembly import Rig
from torquerig.simulation.drawn_loads import drawn_loads

Floats = NDArray[np.float64]

_SLOWEST = 0.05  # [Hz] what is slower passes on as at this frequency


class _Drawn(NamedTuple):
    """A random load: its node, its density over frequencies [Hz], what was drawn of it beyond its mean [N m]."""

    on: str
    density: Callable[[Floats], Floats]
    beyond: Floats


@dataclass(frozen=True, eq=False)
class ChanceOfLoad:
    """The random loads that one simulation drew, from the start of settling on, and the twin of its rig."""

    twin: Twin
    drawn: tuple[_Drawn, ...]

    @classmethod
    def of(cls, rig: Rig, copy: Observed) -> ChanceOfLoad:
        """Return what ``copy``, a simulation by ``rig``, drew of the loads that have a spectrum."""
        placed = rig.at(copy.run)
        spectral = [
            _Drawn(term.on, term.process.density, given - term.process.mean)
            for term, given in drawn_loads(placed, copy.recording)
            if hasattr(term.process, "density")
        ]
        return cls(Twin(placed), tuple(spectral))

    def quieted(self, copy: Observed) -> Observed:
        """Return the simulation without what its loads do to the reading beyond their mean."""
        torque, way = copy.torque, float(np.sign(copy.speed.mean()))
        for load in self.drawn:
            size = fft.next_fast_len(load.beyond.size, real=True)
            at = np.maximum(fft.rfftfreq(size, 1 / copy.rate), _SLOWEST)
            passed = fft.irfft(fft.rfft(load.beyond, size) * self.twin.torque_on(load.on)(at), size)
            against = -way * self.twin.direction(load.on)  # it opposes the motion of its shaft
            torque = torque - against * passed[load.beyond.size - torque.size : load.beyond.size]
        return replace(copy, torque=torque)

    def usual(self, seen: Features, twin: Expectation) -> Floats:
        """Return the density in each band of a simulation as it would be with the loads' usual power.

        Shape (bands,) [(N m)^2/Hz]; ``twin`` is what the twin expects. Where the simulation has more beside the load,
        or passes less of it on than the twin, the smaller of two ways to take its chance out counts.
        """
        loud = twin.load_share * (self._loudness(seen) - 1)
        by_size, by_share = seen.power - twin.power * loud, seen.power / (1 + loud)
        smaller = np.abs(by_size - seen.power) < np.abs(by_share - seen.power)
        return np.where(smaller, by_size, by_share)

    def _loudness(self, seen: Features) -> Floats:
        """Return the density that the loads drew over their usual one [1]; several as the twin passes them on."""
        drawn, usual = np.zeros(seen.band.size), np.zeros(seen.band.size)
        for load in self.drawn:
            passed = np.abs(self.twin.torque_on(load.on)(seen.band)) ** 2
            drawn += passed * _density(seen, load.beyond[-seen.observed.torque.size :])
            usual += passed * load.density(seen.band)
        told = (usual > 0) & np.isfinite(drawn)
        return np.where(told, drawn / np.where(told, usual, 1.0), 1.0)


def _density(seen: Features, given: Floats) -> Floats:
    """Return the density of a load in each band, looked at as the torque is."""
    observed, spectra = seen.observed, []
    for stretch in seen.stretches:
        at = float(np.abs(observed.speed[stretch.start : stretch.stop]).mean())
        lines = [seen.places[index].frequency(at) for index in shown_places(observed, stretch, seen.places)]
        part = given[stretch.start : stretch.stop]
        spectra.append(spectrum(part - part.mean(), observed.rate, lines, smeared=observed.smearing))
    return bands(spectra, observed.rate, observed.notches).power
