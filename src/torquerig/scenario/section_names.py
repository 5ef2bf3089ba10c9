"""The names of the sections of a scenario; a separate module, because the command line needs nothing else of them."""

from __future__ import annotations

SECTIONS = ("scenario", "operating_point", "recording", "measured", "rig", "study")
