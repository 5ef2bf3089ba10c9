"""Long work of the studio in a separate process, so that the page stays usable and the work can be cancelled.

job     a running piece of work: its progress, remaining time, result, end
child   what the process runs
"""
