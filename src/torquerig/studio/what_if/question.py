"""A question of a what-if: the text of a scenario, and what is changed in it."""

from __future__ import annotations

import shlex
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

LENGTH = 2.0
"""Simulated time of every what-if [s]: ten turns of a shaft at 300 rpm, and 50 000 samples at 25 kHz."""


@dataclass(frozen=True, kw_only=True)
class Question:
    """What is to be computed; two equal questions have the same answer while no file changes.

    Parameters
    ----------
    path : Path
        Of the scenario; relative names in it start from its folder.
    text : str
        Of the scenario, as it is edited.
    motor, gearbox : str
        Another entry of the catalog, run as the scenario's study would run it; empty where it is not changed.
    settings : tuple of (tuple of str, str)
        Keys of a value in the scenario, and what replaces it, as it is written in YAML.
    chain : str
        Name of the filter chain.
    catalogs : tuple of Path
        Further catalog folders.
    seed : int
        Fixes every random number.
    """

    path: Path
    text: str = field(repr=False)
    motor: str = ""
    gearbox: str = ""
    settings: tuple[tuple[tuple[str, ...], str], ...] = ()
    chain: str = "none"
    catalogs: tuple[Path, ...] = ()
    seed: int = 1

    def written_settings(self) -> tuple[str, ...]:
        """Return the changed numbers as the option ``--set`` takes them."""
        return tuple(f"{'.'.join(keys)}={text}" for keys, text in self.settings)

    def commands(self) -> Mapping[str, str]:
        """Return the commands that give the same numbers, each by what it computes."""
        changed = [*_option("--motor", self.motor), *_option("--gearbox", self.gearbox)]
        for one in self.written_settings():
            changed += ["--set", one]
        for folder in self.catalogs:
            changed += ["--catalog", str(folder)]
        scenario, seed = self.path.name, ["--seed", str(self.seed)]
        simulate = ["simulate", scenario, "--duration", f"{LENGTH:g} s", "--truth", *seed, *changed]
        drive = [] if self.motor or self.gearbox or self.settings else ["--scenario", scenario]
        return {
            "simulate": shlex.join(["torquerig", *simulate, "--out", "what_if.parquet"]),
            "filter": shlex.join(["torquerig", "filter", "what_if.parquet", "--chain", self.chain, *drive]),
            "size": shlex.join(["torquerig", "size", scenario, *seed, *changed]),
        }


def stated_chain(data: Any) -> str:
    """Return the name of the present filter chain of a scenario's study; ``none`` without a study."""
    study = data.get("study") if isinstance(data, dict) else None
    present = study.get("present") if isinstance(study, dict) else None
    return str(present.get("filter", "none")) if isinstance(present, dict) else "none"


def _option(name: str, value: str) -> list[str]:
    return [name, value] if value else []
