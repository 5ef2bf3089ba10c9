"""Decision matrices: elimination, Pugh and Kesselring from names, criteria and cells; independent of motors.

criterion       direction, requirement, indifference band, value function, weight
cell            number, interval or ``?``, with its origins and what was set by hand
matrix          alternatives against criteria
case            a matrix with baseline, scale, goal and uncertainty
eliminate       selection chart: which alternatives meet the requirements (``+ - ? !``)
near_miss       alternatives that were eliminated narrowly
pareto          dominance and the Pareto set, before any weight
pugh            better, worse or same than a baseline, and against every baseline in turn
convergence     the strongest becomes the baseline until it is stable; cycles of wins
kesselring      weighted points on an absolute scale, as intervals where data is missing
strength        technical against economic rating (S-diagram)
monte_carlo     sampling of intervals, points and weights, each with a random stream by name
kernel          the compiled sampling
best_shares     share of samples in which each alternative is best, for many subsets
robustness      share of Monte Carlo samples in which each alternative takes each rank
flips           exact weights and the smallest changes of scores that flip the winner
value_of_information  which missing fact to ask for first
verdict         robust, fragile, tie or open
ranks           the rank conventions, and the best and worst rank that intervals leave open
matrix_analysis all of it for one case
trace           one cell from the catalog to the verdict
version_comparison  edits between two versions and the changes of the ranking
lost_cells      values of lost cells that give a printed sum
lints           what is wrong with a table: one check per file
matrix_io/      matrices in and out: YAML, Excel, published tables, text
"""
