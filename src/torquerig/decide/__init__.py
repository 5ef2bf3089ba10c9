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
fillings        which lost cells would give a printed sum
lints           what is wrong with a table: one check per file
matrix_io/      matrices in and out: YAML, Excel, published tables, text
"""
