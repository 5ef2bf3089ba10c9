"""Values of a part that come from a catalog entry.

filled         data of a part from YAML and catalog, before it is validated
from_catalog   fields of a part from its catalog entry
motor_effects  ripple lines of a catalog motor        phase_level  ripple from the motor's phases
readings       alternatives for the possible counts, such as pole pairs
"""
