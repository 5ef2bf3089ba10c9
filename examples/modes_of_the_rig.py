"""
At what speeds does a line meet a torsional mode?
=================================================

Modes, margins of the speed loop and the Campbell diagram of the wear rig, from its linear model. Nothing is simulated.
"""

import torquerig as tr

found = tr.modes("wear_rig.yaml")
print(found.summary())
print(found.margins.round(3).to_string(index=False))

# %%
# Each rising line is an order. Where it crosses a level line, it excites a mode; the size of a mark is its size at the
# sensor.

figure = found.plot()
