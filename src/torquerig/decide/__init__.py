"""Choosing: names, criteria and cells in; charts, signs, points, ranks and doubts out. Knows nothing of motors.

criterion       what is asked: direction, demand, indifference band, value function, weight
matrix          what is known of each alternative: a number, an interval or ``?`` per criterion
eliminate       who meets the demands: the selection chart (``+ - ? !``)
pugh            better, worse or same than a datum, and against every datum in turn
kesselring      weighted points on an absolute scale, as intervals where data is missing
robustness      which weight would flip the winner, and how often each alternative is best
ranks           the rank conventions, and the best and worst rank that intervals leave open
sheet           a filled-in table as its readers see it: what the lints look at
seed_tables     published tables read from YAML (``scenarios/seed_tables.yaml``)
recompute       the same engines run over published cells
fillings        which lost cells would give a printed sum
matrix_file     one's own matrix read from YAML (``scenarios/matrix_example.yaml``)
file_schema     what the YAML of both has in common
lints           what is wrong with a table: one check per file
telling         charts, matrices and findings as plain text
telling_printed published tables beside what their cells give
matrix_report   the whole text of ``torquerig matrix``
"""
