"""Studies: every motor x gearbox x filter of a scenario, simulated, measured and ranked.

settings    the study: section of a scenario      study       scenario, settings, catalog and filters together
preflight   checks before the first run           operating_points  of --all-points
loop_margin  distance of a tuned speed loop from instability
candidates  motor on a gearbox, loop tuned        planned_drive  its margins and samples, before its runs
sample_runs  runs of its samples, measured as they arrive
run_study   all drives on all cores               results     of all drives and filters
criteria    requirements and criteria             scoring     figures -> three matrices
reference_report/    the reference report's results compared with the simulated rig
verdict     the best one and its confidence       what_if     effect of an edit
sweep       the study at several values of quantities of its scenario
rated_drives  drives, each with its best filter, for the verdict
as_matrix   a study as a decision matrix file
origins     catalog values behind a figure        trace       calculation of every cell
held_numbers  uncertain numbers that no sample varies
missing_data  names of missing values for a question to the maker
sized_candidates  a drive sized over the duty cycle  ratio_sweep  its motor on every gearbox of the catalog
reference_decision/  a published decision computed again, cell by cell
"""
