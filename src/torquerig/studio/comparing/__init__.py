"""A study as a job of the studio.

question   what is asked: scenario, catalogs
compared   the job, and what it returns
"""
