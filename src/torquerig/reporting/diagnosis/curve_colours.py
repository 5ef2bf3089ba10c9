"""Colours of the curves of a diagnosis: the recording, and the models before and after."""

RECORDED, BEFORE, AFTER = "#9aa5b1", "#c8553d", "#12395b"
