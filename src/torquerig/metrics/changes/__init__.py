"""What changed between two recordings of one rig: lines, levels and bands, each with its interval.

================== ====================================================================
``segments``       a signal in segments of equal length, and its amplitudes at given places
``intervals``      interval of a root mean square, and of the difference of two
``change``         one change, and whether it exceeds the random error
``side``           one of the two recordings: speed, turns, segments over angle and time
``line_changes``   amplitudes of orders and of fixed frequencies
``level_changes``  mean, and rms in bands without the lines
``comparison``     all changes of two recordings, and what cannot be compared
================== ====================================================================
"""
