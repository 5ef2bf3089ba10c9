"""Parts of ``torquerig filter``: block by block, evaluation, text."""
