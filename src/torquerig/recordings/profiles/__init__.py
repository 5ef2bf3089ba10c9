"""How the set-point runs over time, one profile per file; each is a value that answers by the same questions.

profile     the questions: word, length, speed and load at a time, corners
steady      holds the set-point            ramp        10 % to 100 %, then holds (both as CONTRACTS.md fixes them)
reversal    two sine periods               duty_cycle  segments, repeated
tabulated   the rows of a file             from_file   reading such a file; gaps: what no profile may have
corners     straight lines between points in time, with jumps
"""
