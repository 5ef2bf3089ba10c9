"""Figures of merit of drives, readings and filters.

figure          a number with its interval, unit and source
drive_margins   speed, torque, sensor, new parts and price of a drive
shares          shares of load, cogging, electrical and mechanical ripple in the reading
truth_error     rms error of a reading against the true load
load_error      the same by frequency band, in energy, at impacts and in delay
filter_evaluation  effect of a filter chain on a recording, compared with the true load and a placebo
motor_facts     catalog values of a motor on a gearbox
residual_disturbance  rms of the disturbance behind a filter chain
sizing/         sizing of a drive for a cycle, and the use of its sensor
omitted_ripple  ripple of a motor's class that its known lines omit
"""
