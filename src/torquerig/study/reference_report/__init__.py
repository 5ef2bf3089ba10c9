"""The results of the reference report compared with the simulated wear rig.

published      printed values: Tables VIII and IX, the drop of mechanical noise; and which cells a fit uses
conditions     the rig at one occupancy and particle size, with a scaled load
superposition  a reading as lines plus a scalable load: reduction of its standard deviation in closed form
fitting        three free parameters, fitted to half of the published cells
cells          every cell simulated with the fitted values, over several seeds
mechanical     the drop of mechanical noise with load
half_power     frequency below which half of the power of a signal lies
filter_steps   the report's filter in the steps of its figures
reasons        differences between simulated and published values, as sentences
results        all of it together
"""
