"""How good a model is.

leftover       where it is significantly wrong         whole_fit   whether it fits as a whole
by_simulation  whether a simulation is wrong there too  one_load    whether runs differ as no load does
held_out       how well it predicts what no fit has seen
untold_runs    of which the distribution of values alone tells that
narrow_humps   noise at one order or one frequency    fixed_after_all  orders that turned out to be tones
spread_lines   lines a hertz or two wide              passing   what comes and goes within a run
band_excess    what two runs are compared by
own_lines      lines of an effect that was found       slow_rhythm  pulses once in a second or so
chance         how probable a residual is             share_explained  how much goes where an effect changes something
withdrawn      why what was found is not believed
changing       what drifts in all steady runs         scattered_levels  slow torque that follows no course
last_questions what no single place shows             one_gain    all lines change by one factor
numbers_far_off  numbers that stand in for more      load_over_time  loads that change or let go
both_ways      a mode whose own band stays wrong up and down
forgiven_bands  those filled by what has a spectrum of its own
"""
