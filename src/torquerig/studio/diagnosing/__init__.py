"""A diagnosis as a job of the studio.

question    what is asked: scenario, recordings, engine
diagnosed   the job, and what it returns
"""
