"""What a filter chain is worth, told from signals alone.

placebo       the same chain at empty orders beside its own: what any so many notches would cut
moved_chain   a chain whose lines are moved by so many orders
turned        a recording moved up by so many orders: the placebo of combs, whose teeth stand everywhere
inserted      what the chain makes of a step and a hit that are put into the recording
hits          the largest hits of a known load, and how high and steep a reading shows them
delay         how late one signal follows another
bands         what of a signal's mean square lies in which band of frequencies
known_angle   the recording with the angle that the true lines give, for chains whose lines are moved
"""
