"""What a model says that recordings should show.

expectation    all features of a run, by the linear twin    simulated   the same from simulations
added_signals  tones, drift and rings of the electronics    skirts      what a shaken speed puts beside lines
rounding_noise what coarse codes add                        correction  what an effect beyond the twin changes
phased         a rig whose lines have the phases of a run   sway        what slow lines take from fast ones
chance_of_load what a simulated load drew, taken out of its features
"""
