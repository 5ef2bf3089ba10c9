"""How much of a torque ripple at the motor, and of a load, the sensor sees at each frequency: one picture.

The linear twin of the wear rig with its speed loop closed; the ripple's share is counted at the output.
Run: python examples/which_source_reaches_the_sensor.py [PICTURE.svg]
"""

import sys
from pathlib import Path

import numpy as np

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.reporting.figures.picture import new_figure, write_picture
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.linear import matrices, spring_response
from torquerig.simulation.lower import lower

document = read_document(shipped_scenarios() / "wear_rig.yaml")
rig = read_scenario(document, load_catalog(shipped_folder()), seed=1).rig
lowered = lower(rig, 1)
print("modes:", ", ".join(f"{mode:.1f} Hz" for mode in matrices(lowered).undamped_frequencies()[1:]))
frequency = np.geomspace(1, 2000, 2000)
response = spring_response(lowered, rig.measured, frequency, speed_loop=True)
figure = new_figure(7, 4)
axes = figure.add_subplot()
axes.loglog(frequency, abs(response["motor"]) / (rig.run.gear_ratio or 1), label="ripple of the motor (per ratio)")
axes.loglog(frequency, abs(response[rig.node("wear_part")]), label="load at the wear part")
axes.set(xlabel="frequency [Hz]", ylabel="N m at the sensor per N m at the source")
axes.legend()
picture = Path(sys.argv[1] if len(sys.argv) > 1 else "which_source_reaches_the_sensor.svg")
write_picture(figure, picture, overwrite=True)
print(f"wrote {picture}")
