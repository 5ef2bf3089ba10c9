"""
Ripple of six-step commutation and of a servo
=============================================

How much does the torque of a brushless motor vary within one electrical period, and how much that of a servo motor?
No ripple is put in. It follows from resistance, inductance, back-EMF and DC link, drawn from the catalog's intervals.
The mean torque is that of the wear rig at 5 % occupancy.
"""

import matplotlib.pyplot as plt
import numpy as np

import torquerig as tr
from torquerig.rig.host_changes import DriveRipple, waves_of
from torquerig.rig.parts import MotorPhases
from torquerig.rig.steady import steady_torque

# %%
# ``motor.ripple=from_phase_level`` replaces the motor's electrical line by the lines of its phases. The first motor is
# commutated in six steps, the second by field-oriented control.

figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
for motor in ("bldc-12n14p", "HDS6A-0104A"):
    changes = {"motor.ripple": "from_phase_level", "motor.catalog": motor}
    rig = tr.read_scenario("wear_rig.yaml", changes=changes).rig
    (phases,) = rig.parts_of(MotorPhases)
    waves = waves_of(rig.part("motor.commutation").changes_in_host(rig), DriveRipple)
    angle = np.linspace(0, 2 * np.pi / phases.pole_pairs, 2000)
    factor = 1 + sum(wave.amplitude * np.cos(wave.order * angle + (wave.phase or 0.0)) for wave in waves)
    axes.plot(angle * phases.pole_pairs * 180 / np.pi, steady_torque(rig, "motor") * factor, label=motor)
    depth = {wave.order / phases.pole_pairs: f"{wave.amplitude:.2%}" for wave in waves if wave.amplitude > 1e-3}
    print(motor, "lines by electrical order:", depth or "none above 0.1 %")
axes.set(xlabel="electrical angle [deg]", ylabel="motor torque [N m]", ylim=(0, None))
axes.legend()
plt.show()
