"""
How much of a ripple and of a load reaches the sensor
=====================================================

A torque ripple at the motor, or a load at the wear part, of 1 N m at some frequency: what amplitude does the sensor
show? The answer is the frequency response of the rig's linear model with its speed loop closed.
"""

import matplotlib.pyplot as plt
import numpy as np

import torquerig as tr
from torquerig.simulation.linear import spring_response
from torquerig.simulation.lower import lower

rig = tr.read_scenario("wear_rig.yaml").rig
frequency = np.geomspace(1, 2000, 2000)
response = spring_response(lower(rig, 1), rig.measured, frequency, speed_loop=True)

# %%
# The ripple is counted at the output, so its response is divided by the gear ratio.

figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
axes.loglog(frequency, abs(response["motor"]) / (rig.run.gear_ratio or 1), label="ripple of the motor (per ratio)")
axes.loglog(frequency, abs(response[rig.node("wear_part")]), label="load at the wear part")
axes.set(xlabel="frequency [Hz]", ylabel="N m at the sensor per N m at the source")
axes.legend()
plt.show()
