"""A published decision computed again from catalog and simulation, compared cell by cell.

plan             the file that states how each published criterion is computed
known_figures    figures of each motor on each gearbox from catalog and simulation
computed         the published tables as matrices of computed cells
cell_comparison  computed and published tables, cell by cell
reasons          why a cell differs: value, interpretation, baseline, direction or a missing value
answer           the motor to buy or keep, and the confidence
decision         all of it together
"""
