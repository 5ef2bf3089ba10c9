"""Lints: checks for errors in a table, printed or calculated; one file per subject.

weights         weights that do not sum to 1
discrimination  rows that do not distinguish alternatives; rows where all have ``-``
duplication     identical and strongly correlated rows
baseline        ``+`` against a baseline that has it; a baseline that is not ranked or never changes
rank_checks     tied sums with different ranks; mixed rank conventions
sums            sums and products that do not follow from the cells
unknowns        ``?`` counted as 0; ``?`` passed as yes
requirements    a wish used as a requirement
polarity        criteria without a clear direction
ties            equal highest sums
goal            a stated goal without a criterion
names           one thing under several names, or two nearly equal ones; equal ratings with different marks
price           price inside the technical rating
audit           all of them over a table_set of tables
finding         the result of a check
"""
