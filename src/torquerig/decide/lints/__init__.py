"""What is wrong with a table: one check per question, run over any sheet, printed or computed.

weights         weights that do not sum to 1
discrimination  rows that do not tell alternatives apart; rows where everybody has ``-``
duplication     identical and strongly correlated rows
datum           ``+`` against a datum that has it; a datum that is not ranked or never changes
rank_checks     tied sums with different ranks; mixed rank conventions
sums            sums and products that do not follow from the cells
unknowns        ``?`` counted as 0; ``?`` passed as yes
demands         a wish used as a demand
polarity        criteria of which nobody can tell whether high is good
ties            equal sums in front
goal            a stated goal without a criterion
names           one thing under several names, or two nearly equal ones; equal ratings judged differently
price           price inside the technical rating
audit           all of them over a book of tables
finding         what a check says
"""
