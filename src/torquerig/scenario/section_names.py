"""The names of the sections of a scenario; a module of its own, because the command line needs nothing else of them."""

from __future__ import annotations

SECTIONS = ("scenario", "operating_point", "recording", "measured", "rig", "study")
