"""Blind trials: recordings by a program that is independent of the simulator, and scores of their diagnoses.

- ``rig_program``   the independent rig: its own equations, integrator and effects; it imports nothing of torquerig
- ``trials``        cases of a set of trials: clean, wrong parameters only, effects in the library, effects outside it
- ``riddle``        the 280 Hz line of the reference report: mesh, comb or resonance, at one speed and at two
- ``sealed``        sealed answers: their hash is printed before any diagnosis, and verified when they are opened
- ``scoring``       scores of diagnoses against the sealed answers
- ``prove``         the stages of ``python -m proof``
- ``page``          the page of results
- ``baselines``     simpler methods on the same recordings
- ``library``       diagnoses with a reduced library
- ``fleet``         drawn rigs of many designs with hidden effects; it imports nothing of torquerig
- ``strangers``     effects that no mechanism of the library describes
- ``referee``       ``python -m proof fleet``: sets on the fleet, diagnosed by the command and judged
- ``make``          ``python -m proof.make --seed N --cases K --out FOLDER``
- ``score``         ``python -m proof.score FOLDER``
"""
