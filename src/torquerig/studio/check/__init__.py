"""What the recordings of a folder can tell apart, before a diagnosis is made.

runs_checked   the check of `torquerig diagnose --check`, as values
separable      which causes these speeds, loads and channels separate, and which they do not
"""
