"""Parts of ``torquerig diagnose``: ``check_likelihood`` says what recordings would show, before a diagnosis."""
