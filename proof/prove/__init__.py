"""The stages of ``python -m proof``.

- ``plan``        the options
- ``trial_set``   the rigs of one seed: sealed, then recorded; finished ones are kept
- ``jobs``        cases distributed over worker processes
- ``diagnosing``  diagnosis and baseline verdicts of one rig, without access to answers
- ``opened``      the stage that needs the opened answers: the oracle
- ``scored``      diagnoses, baselines and oracle compared with the answers
- ``practice``    a folder of practice recordings with their answers
- ``campaign``    all stages in order
"""
