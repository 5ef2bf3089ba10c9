"""Scenario files.

reading        file -> Rig with catalog values, uncertainties and assumptions    writing    the way back
model          a scenario as a value                   kinds      the kinds of parts and effects
sections       the sections of a file                  study_section  the one of a comparison
measured       the measured places                     overrides  --set path=value

catalog_values/  values of a part from its catalog entry
numbers/         numbers as a scenario states them
conditions/      the conditions of a run: speed, profile, load; sample rate and length
recorded/        a scenario and the recordings of its rig
checks/          what is wrong, impossible or unused

kinematics     poles, slots, ratio, teeth and torque gain of a rig               shafts     its shafts and their lines
drive_requirement  required speed and torque of the motor                        mean_load  at the measured shaft
load_response  reading per load of the linear twin
"""
