"""
How much of a ripple and of a load reaches the sensor
=====================================================

A torque ripple at the motor, or a load at the wear part, of 1 N m at some frequency: what amplitude does the sensor
show? The answer is the frequency response of the rig's linear model with its speed loop closed.
"""

import matplotlib.pyplot as plt
import numpy as np

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.linear import matrices, spring_response
from torquerig.simulation.lower import lower

document = read_document(shipped_scenarios() / "wear_rig.yaml")
rig = read_scenario(document, load_catalog(shipped_folder()), seed=1).rig
lowered = lower(rig, 1)
print("torsional modes:", ", ".join(f"{mode:.1f} Hz" for mode in matrices(lowered).undamped_frequencies()[1:]))

# %%
# The ripple is counted at the output, so its response is divided by the gear ratio.

frequency = np.geomspace(1, 2000, 2000)
response = spring_response(lowered, rig.measured, frequency, speed_loop=True)
figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
axes.loglog(frequency, abs(response["motor"]) / (rig.run.gear_ratio or 1), label="ripple of the motor (per ratio)")
axes.loglog(frequency, abs(response[rig.node("wear_part")]), label="load at the wear part")
axes.set(xlabel="frequency [Hz]", ylabel="N m at the sensor per N m at the source")
axes.legend()
plt.show()
