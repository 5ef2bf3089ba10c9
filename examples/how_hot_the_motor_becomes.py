"""
How hot does the motor become?
==============================

The duty cycle of the wear rig is repeated without end. The catalog knows the motor's thermal data as intervals only, so
the temperatures are intervals, too.
"""

import torquerig as tr

scenario = tr.read_scenario("wear_rig.yaml", motor="HDS6A-0104A", changes={"operating_point.profile": "duty_cycle"})
heat = tr.duty(scenario, ambient=30.0)
print(heat.summary())
print(heat.to_frame().to_string(float_format="%.3g"))

# %%
# Speed and torque of the cycle, the settled temperatures, and the way there from cold.

figure = heat.plot()
