"""The reference report's results beside the simulated wear rig.

published   what the report prints: Tables VIII and IX, the drop of mechanical noise; which cells a fit may see
conditions  the rig at one occupancy and particle size, its load scaled
superposed  a reading as lines plus a load that can be scaled: the cut of its standard deviation in closed form
fitting     three free parameters, fitted to half of the published cells
cells       every cell simulated at the fitted values, with its spread over seeds and what would be needed
mechanical  the drop of mechanical noise with load
reasons     where the simulated figure differs from the published one, and why: computed, in words
results     all of it together
"""
