"""Motor temperature: a two-node network of winding and housing, solved exactly.

two_node      the network, for stretches of constant loss
motor_duty    mean square of torque and speed per stretch, from a required motion or a recording
thermal_motor one variant of a motor within the catalog's intervals: losses, network, limit
warming       temperatures of a variant over a duty: course, steady cycle, peak, time to the limit
motor_variants  the variants within the catalog's intervals, and the assumptions for them
duty_temperatures  figures of a duty with their intervals over all variants; duty_text: the same as text
temperature_bands  temperatures over time with the band of all variants
"""
