"""Choosing: names, criteria and cells in; charts, signs, points, ranks and doubts out. Knows nothing of motors.

criterion       what is asked: direction, demand, indifference band, value function, weight
cell            what is known of one: number, interval or ``?``, its origins, what was set by hand
matrix          alternatives against criteria
case            a matrix with datum, scale, goal and doubts
eliminate       who meets the demands: the selection chart (``+ - ? !``)
near_miss       who was eliminated by a hair
pareto          dominance and the Pareto set, before any weight
pugh            better, worse or same than a datum, and against every datum in turn
convergence     the strongest becomes the datum until it stands; wins that run in a circle
kesselring      weighted points on an absolute scale, as intervals where data is missing
strength        technical against economic rating (S-diagram)
draws           what is drawn and how far: intervals, points, weights, each with a stream by name
kernel          the compiled draws
robustness      how often each alternative takes each rank
flips           exact weights and the smallest changes of scores that flip the winner
missing         which missing datum to ask for first
verdict         robust, fragile, tie or undecidable
ranks           the rank conventions, and the best and worst rank that intervals leave open
working         all of it for one case
trace           the way of one cell from the catalog to the verdict
comparing       what was edited between two versions, and what that did
sheet           a filled-in table as its readers see it: what the lints look at
computed_sheets one's own three tables as such sheets
seed_tables     published tables read from YAML (``scenarios/seed_tables.yaml``)
recompute       the same engines run over published cells
fillings        which lost cells would give a printed sum
matrix_file     one's own matrix read from YAML (``scenarios/matrix_example.yaml``)
matrix_schema   what that YAML may hold                   matrix_cells    its cells, and those of catalog motors
matrix_writing  a case as YAML
matrix_sheet    one's own matrix read from Excel          sheet_layout    where things stand in it
workbook_tables tables of any workbook, with places
file_schema     what the YAML of matrices and published tables has in common
lints           what is wrong with a table: one check per file
telling         charts, matrices and findings as plain text
telling_sure    verdict, draws, flips, datum runs, open facts as plain text
telling_printed published tables beside what their cells give
matrix_report   the whole text of ``torquerig matrix``
"""
