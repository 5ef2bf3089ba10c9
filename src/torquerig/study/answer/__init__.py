"""The answer of a study in plain sentences, its uncertainty, and what would change it.

open_questions      requirements on the winner that a missing value leaves open
equally_good        the best drives among some combinations, and whether one of them is clearly best
what_to_do          sentences and the three large figures
uncertainty_budget  measurement uncertainty of a reading on the recommended drive (GUM)
what_would_change   weights, values and requirements that lead to another winner
"""
