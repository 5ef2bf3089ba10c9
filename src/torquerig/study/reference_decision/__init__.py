"""A published decision made again: the same tables from catalog and simulation, beside the published ones.

plan       the file that says how each published criterion is computed
figures    what catalog and simulation say of each motor on each gearbox
computed   the published tables as matrices, and what the engines make of them
beside     computed and published cell by cell
reasons    why a cell differs: value, reading, datum, polarity or a missing datum
answer     which motor to buy or keep, and how sure that is
decision   all of it
"""
