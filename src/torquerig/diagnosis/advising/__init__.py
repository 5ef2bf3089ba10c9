"""What to measure next.

next_run   which run would tell rivals apart          candidate_runs  the menu of runs
"""
