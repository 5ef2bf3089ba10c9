"""Sizing of a drive for a cycle: torque, speed, temperature, gearbox, current, energy and use of the sensor.

open_data      a figure over all open values of the catalog, and the value that decides
sized_drive    a rig with its motor, gearbox and sensor, and its required torque for any open values
required_torque   rms and peak torque, power, speed          speed_torque   continuous and intermittent region
inertia_ratio  load over rotor                            thermal_use    temperature by the two-node model
output_torque  torque at the output shaft                 gearbox_use    its torques, speed, service factor, reversal
drive_current  amperes from the torque constant           regeneration   energy back to the DC link per cycle
best_ratio     alpha-beta: ideal ratio, range that fits   sensor_use     the sensor's range and limit load
load_fidelity  share of the load in the reading           drive_sizing   all of it, each with its limit
"""
