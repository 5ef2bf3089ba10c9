"""What is seen: recordings, their files, the stages that change them, and the lines that stand in them.

recording          equally sampled channels of one run
run                the conditions on the test sheet; set_point: the speed that it promises, over time
profiles           how that speed runs: steady, ramp, reversal, duty cycle, table
files              recordings in and out of every format
stage              the one verb of sensor stages and filters: Recording -> Recording
stages             what the sensor and its electronics do, one effect per file
filters            what takes disturbance out, one filter per file
chain              stages by one name, and the seed's two chains; chain_file reads them from YAML by chain_schema,
                   chain_form and chain_line_stages
streaming          chains on recordings too long to be held, block by block; reach: how far their stages look
inspection         what stands in a recording: levels, runs, spikes, dropouts, spectrum, in one pass
effect             what a chain did: spread, mean, energy, line levels; effect_joined: from its blocks
judging            what a chain is worth: placebo at empty orders, steps put in, hits, delay, bands
order_analysis     order spectrum and map; lines of the shaft told from fixed frequencies
teeth              what tooth counts fix
kinematics         the order lines of a motor and gearbox
coincidences       lines that stand on the mains or on each other, and a better speed
orders             the report of all that; orders_telling puts it into words
best_angle         the best angle and speed that a recording has, and which source that is
angle              the motor's angle from its channels; tacho: by pulses; speed_from_torque: by the comb of lines
                   (with speed_course, where it wanders by per cents, wander, where it strays slowly from a course,
                   angle_within_a_turn, where it ripples with the shaft, speed_far_off, where the sheet is wrong,
                   coherence, how far lines stand out along an angle, and smooth_course)
load_response      what a model of the rig says the sensor makes of the load
line_fit           sines of given orders, fitted block by block
spectrum           amplitude spectra
coloured_noise     random signals with a given colour
"""
