"""How good a model is.

leftover   where it is significantly wrong            whole_fit   whether it fits as a whole
held_out   how well it predicts what no fit has seen
"""
