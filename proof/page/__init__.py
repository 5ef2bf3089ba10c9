"""The page of a proof: its chapters, in the order in which a sceptic reads them.

- ``proof_page``   the whole page
- ``headline``     every figure beside what is asked, and beside the baselines
- ``trials_made``  seeds, seals, and what was hidden
- ``strata``       by what was hidden, size, mechanism and programme; parameters; with the reference's own laws
- ``trust``        calibration of the confidence, harm, improvement
- ``null``         what effects gain where nothing is hidden, and the thresholds that follow
- ``cost``         time and memory of a diagnosis
- ``riddle``       the twelve rigs of the 280 Hz riddle
- ``known``        practice recordings
- ``real``         real recordings
- ``failures``     every case that was not right
- ``cells``        shares, figures and names as cells
"""
