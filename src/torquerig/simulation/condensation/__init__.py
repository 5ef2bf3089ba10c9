"""Condensation: a shaft line with its modes far above the recorded band left out, in the same closed vocabulary.

=================== =============================================================================
``lowered_for``     ``lower_for``: a rig lowered for one sample rate, condensed where that is needed
``partial_systems`` the two reductions: a small mass taken quasi-statically, a stiff spring taken as rigid
``reduction``       both applied from the highest partial frequency downwards
``beforehand``      what a simulation at one sample rate will leave out
``accuracy``        change of natural frequencies and of the reading's response below the band
=================== =============================================================================
"""
