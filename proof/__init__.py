"""The proof: recordings made blind by a program that is not the simulator, and the scores of what was said of them.

- ``rig_program``   the independent rig: its own equations, integrator and effects; it imports nothing of torquerig
- ``trials``        which cases a set of trials holds: clean, wrong parameters only, left out, in no library
- ``riddle``        the 280 Hz line of the reference report: mesh, comb or resonance, at one speed or two
- ``sealed``        answers written apart, their hash printed before anything is diagnosed, verified when opened
- ``scoring``       what a set of diagnoses is worth against the sealed answers
- ``prove``         what ``python -m proof`` does, stage by stage
- ``page``          its page, chapter by chapter
- ``baselines``     what others would say of the same recordings
- ``oracle``        what the true mechanisms reach with the diagnosis' own fits
- ``library``       the diagnosis with fewer effects in its library
- ``null_gains``    what effects gain on rigs with nothing hidden
- ``thresholds``    least gains from the tail of these
- ``make``          ``python -m proof.make --seed N --cases K --out FOLDER``
- ``score``         ``python -m proof.score FOLDER``
"""
