"""What a report shows of a diagnosis.

comparison  both models beside the recordings         comparison_curves  its curves
"""
