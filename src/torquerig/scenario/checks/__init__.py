"""What is wrong, impossible or unused in a scenario.

misplaced          the right place of a key in the wrong one
requirement_check  impossible requirements are errors, those beyond a rating are flagged
unused             what a run does not use               locked_ends  what rests at a locked end
"""
