"""What to buy: every motor x gearbox x filter of a scenario, simulated, measured and decided.

settings    the study: section of a scenario      study       scenario, settings, catalog and filters together
preflight   every fault before the first run      points      occupancies and particle sizes of --all-points
candidates  a motor on a gearbox, loop tuned      drive_run   one drive: simulate, filter, measure
run_study   all drives on all cores               results     what was found
criteria    demands and criteria of the study     scoring     figures -> three matrices
reference_report/    the reference report's results compared with the simulated rig
verdict     which one, and how sure               what_if     what an edit changes
rated_drives  drives by their best filter, judged for every answer that is given
as_matrix   a study as a matrix of one's own, to be edited
origins     the catalog values behind a figure    trace       the way of every cell
asked       what is missing, in the words of a buyer
sized_candidates  a drive sized over the duty cycle  ratio_sweep  its motor on every gearbox of the catalog
reference_decision/  a published decision computed again, cell by cell
"""
