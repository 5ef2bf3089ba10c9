"""Evaluation of a filter chain from signals alone.

================= ===============================================================================
``placebo``       placebo test: the variance that the same chain removes at empty orders
``shifted_chain`` a chain with its lines shifted by some orders
``order_shift``   a recording shifted by some orders: the placebo test of combs
``step_response`` the chain's response to a step and a hit that are added to the recording
``hits``          peak and rise time of the largest load hits in a reading; ``rise``: the rise time
``delay``         delay of one signal behind another
``bands``         rms of a signal in frequency bands
``load_scale``    decay time of the load's hits, and the frequency bands, on which all of it is evaluated
``known_angle``   a recording with the angle estimated from the true lines, for shifted chains
================= ===============================================================================
"""
