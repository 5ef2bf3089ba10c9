"""The page of the blind trials, chapter by chapter.

- ``proof_page``   the whole page
- ``headline``     all scores compared with the requirements and the baselines
- ``trial_sets``   seeds, seals, and kinds of cases
- ``strata``       scores by hidden effects, size, mechanism and runs; parameters; the simulator's laws
- ``confidence``   calibration of the confidence, improvement on held-out data
- ``cost``         time and memory of a diagnosis
- ``riddle``       the twelve rigs with a 280 Hz line
- ``practice``     practice recordings
- ``failures``     every wrong case
- ``cells``        shares, scores and names as cells
"""
