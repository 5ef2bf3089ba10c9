"""A study's file.

reading          file -> Rig with catalog values, uncertainties, assumptions    overrides   --set path=value
operating_point  speed, profile, occupancy, particle size                       kinematics  poles, slots, ratio, teeth
from_catalog     what a catalog entry gives a part, and the lines that come with a motor
"""
