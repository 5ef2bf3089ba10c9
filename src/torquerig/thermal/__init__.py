"""How hot a motor becomes: two nodes, winding and housing, solved exactly.

two_node      the network: heat in two bodies and between them, one stretch of constant current at a time
motor_duty    mean square of torque and of speed, stretch by stretch: from a demand or from a recording
thermal_motor one possible copy of a motor: losses, network, limit
warming       the temperatures of a copy over a duty: course, steady cycle, peak, time to the limit
copies        the copies that the catalog's intervals allow, and what had to be assumed
judged        the figures of a duty with their intervals over all copies; telling puts them into words
bands         temperatures over time with the band of all copies
"""
