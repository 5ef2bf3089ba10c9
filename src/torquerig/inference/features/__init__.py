"""What recordings show, without a model.

line_places     which lines a block can show             line_powers     power of the lines of a block
bands           spectrum without the lines, in bands     run_features    all of it for one run, and mean torques
side_lines      where a line may have side lines         segment        blocks of a run at one speed
impacts         envelopes over the angle                rests           how long and how often a torque is near zero
noise_ratios    power over noise, for                    line_search     lines that no model has, in all runs
waves           the waves of lines                       regression      amplitudes of lines by least squares
kernel          compiled loops over waves
tuned_tone      frequency of a tone by whole runs
line_skirts     whether a peak is a line or part of something wider
"""
