"""Tables with several columns of times.

============== =====================================================================================
``own_times``  each column gets the rate and the start of its times; equal times are read once
``clocks``     the rate of each column of times, and which of them are the same
============== =====================================================================================
"""
