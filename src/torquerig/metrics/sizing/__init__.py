"""Whether a drive is large enough, as sizing programs ask, and what they leave out: what the sensor sees of it.

open_data      a figure over everything that the catalog leaves open, and which datum decides
sized_drive    a rig with its motor, gearbox and sensor, and its demand for any values of what is open
asked_torque   rms and peak torque, power, speed          speed_torque   continuous and intermittent region
inertia_ratio  load over rotor                            thermal_use    how hot, by the two-node model
output_torque  what the gearbox hands on                  gearbox_use    its torques, speed, service factor, reversal
drive_current  amperes from the torque constant           regeneration   energy back to the DC link per cycle
best_ratio     alpha-beta: ideal ratio, range that fits   sensor_use     the sensor's range and limit load
load_fidelity  how much of the load reaches the reading   sizing         all of it, each with its limit and a word
"""
