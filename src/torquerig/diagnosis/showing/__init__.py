"""What a report shows of a diagnosis.

comparison         both models beside the recordings         comparison_curves  its curves
Under measured motion
motion_comparison  both models beside the recordings         motion_curves      its curves
motion_lines       lines that both models leave              motion_scores      what was tried in a finding's place
"""
