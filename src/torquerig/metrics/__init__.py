"""Numbers to quote.

figure          a number with its interval and where it comes from
drive_margins   speed, torque, sensor, new parts and price of a drive
shares          what of the reading is load, cogging, electrical and mechanical ripple
truth_error     how far a reading is from the true load
omitted_ripple  what a motor's class has and its known lines leave out
"""
