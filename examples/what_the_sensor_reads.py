"""
What the torque sensor reads, before and after a filter
=======================================================

Four seconds of the wear rig are simulated. The filter of the reference report, as its code runs it, is applied to the
reading. Both are compared with the true load, which only a simulation knows.
"""

import torquerig as tr
from torquerig.metrics.truth_error import truth_error
from torquerig.reporting.figures.spectrum_figure import spectrum_figure
from torquerig.scenario.kinematics import kinematics_of

scenario = tr.read_scenario("wear_rig.yaml")
reading = tr.simulate(scenario, duration=4.0, seed=1)
filtered = tr.filter(reading, "report_filter_code")

# %%
# The standard deviation falls. The error to the true load falls less: the notches remove load, too.

for name, recording in (("unfiltered", reading), ("filtered", filtered)):
    torque = recording.torque()
    error = truth_error(recording, reading)
    print(
        f"{name}: mean {torque.mean():.3f} N*m, std {torque.std():.3f} N*m, error to the true load {error:.3f} N*m rms"
    )

# %%
# The amplitude spectrum. Each marked line is an order of a shaft; the colour names its cause.

kinematics = kinematics_of(scenario.rig)
speed = scenario.rig.run.speed or 0.0
figure = spectrum_figure(reading, filtered, lines=kinematics.lines(1), motor_speed=speed, ratio=kinematics.ratio)
