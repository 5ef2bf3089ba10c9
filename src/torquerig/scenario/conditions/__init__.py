"""The conditions of a run: ``operating_point:`` and ``recording:``.

operating_point     speed, profile, occupancy, particle size
profile_text        a duty cycle or a table as written
planned             the same in speeds of the motor
recording_settings  sample rate, length and settling time
"""
