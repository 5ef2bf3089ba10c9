"""A diagnosis as a job of the studio.

question    what is asked: scenario, recordings
diagnosed   the job, and what it returns
each_effect  how much each part that was added changes the reading
"""
