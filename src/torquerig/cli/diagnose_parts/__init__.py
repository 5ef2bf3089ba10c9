"""Parts of ``torquerig diagnose``.

by_rules, by_likelihood   the two engines, with their answers in words and pages     diagnosed   what both return
"""
