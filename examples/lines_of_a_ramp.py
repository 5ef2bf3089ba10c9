"""
Which lines follow the shaft, and which have a fixed frequency?
===============================================================

A line of a shaft keeps its order when the speed changes. Mains hum keeps its frequency. A ramp separates them; a run at
one speed cannot. Here 50 Hz hum is added to the wear rig, and the speed rises evenly during 12 s.
"""

import torquerig as tr

scenario = tr.read_scenario("wear_rig.yaml", changes={"operating_point.profile": "ramp"})
hum = tr.mechanisms.MainsInterference(name="hum", amplitudes=(0.02,))
ramp = tr.simulate(scenario + hum, duration=12.0, seed=1)
found = tr.order_lines(ramp)
print(found.summary())
print(found.to_frame().to_string(index=False, float_format="%.3g"))

# %%
# In the order map the lines of the shaft are upright. In the Campbell diagram they are straight lines through the
# origin, and the hum is level.

figure = found.plot()
