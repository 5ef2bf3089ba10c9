"""What to buy: every motor x gearbox x filter of a scenario, simulated, measured and decided.

settings    the study: section          study      scenario, settings, catalog and filters together
candidates  a motor on a gearbox        drive_run  one drive: simulate, filter, measure
run_study   all drives on all cores         results    what was found               points    operating points
criteria    demands and criteria        preflight  every fault of the file before the first run
scoring     figures -> three matrices   verdict    which one, and how sure            what_if  what an edit changes
"""
