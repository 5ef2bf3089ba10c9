"""Numbers to quote.

figure          a number with its interval and where it comes from
drive_margins   speed, torque, sensor, new parts and price of a drive
shares          what of the reading is load, cogging, electrical and mechanical ripple
truth_error     how far a reading is from the true load
load_error      the same by band, in energy, in hits, in time
judgement       what a chain is worth on a recording: that, and a placebo
motor_facts     what a purchase table asks of a motor
left_disturbance  what a filter chain leaves of the disturbance
sizing/        whether a drive is large enough for a cycle, and what the sensor sees of it
omitted_ripple  what a motor's class has and its known lines leave out
"""
