"""
What the torque sensor reads, before and after a filter
=======================================================

Four seconds of the wear rig are simulated. The filter as the reference report's code runs it is applied to the
reading. Both are compared with the true load, which only a simulation knows.
"""

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.filters.chains.filter_chain import report_filter_code_chain
from torquerig.metrics.truth_error import truth_error
from torquerig.reporting.figures.spectrum_figure import spectrum_figure
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.reading import read_scenario
from torquerig.simulation.simulator import simulate

document = read_document(shipped_scenarios() / "wear_rig.yaml")
rig = read_scenario(document, load_catalog(shipped_folder()), seed=1).rig
reading = simulate(rig, duration=4.0, seed=1, wander=2e-4)
kinematics = kinematics_of(rig)
chain = report_filter_code_chain(kinematics)
filtered = chain.apply(reading)

# %%
# The standard deviation falls. The error to the true load falls less: the notches remove load, too.

for name, recording in (("unfiltered", reading), ("filtered", filtered)):
    torque = recording.torque()
    error = truth_error(recording, reading)
    print(f"{name}: mean {torque.mean():.3f} N*m, std {torque.std():.3f} N*m, error to the true load {error:.3f} N*m rms")

# %%
# The amplitude spectrum. Each marked line is an order of a shaft; the colour names its cause.

figure = spectrum_figure(reading, filtered, lines=chain.lines, motor_speed=rig.run.speed or 0.0, ratio=kinematics.ratio)
