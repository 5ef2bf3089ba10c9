"""What ``python -m proof`` does, stage by stage.

- ``plan``        what is asked for
- ``trial_set``   the rigs of one seed: sealed, then recorded, or found as they were left
- ``jobs``        many cases over worker processes, each done once
- ``diagnosing``  recordings of one rig to a diagnosis and the baselines' verdicts; sees no answers
- ``opened``      what needs the opened answers: the oracle, and what clean rigs gain
- ``scored``      diagnoses, baselines and oracle beside the answers
- ``practice``    a folder of practice recordings with their answers
- ``campaign``    all of it in its order
"""
