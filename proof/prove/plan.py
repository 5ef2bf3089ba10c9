"""Options of the blind trials."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, kw_only=True)
class Plan:
    """Trials, folder of results and number of processes.

    Parameters
    ----------
    seeds : tuple of int
    cases : int
        Number of rigs per seed.
    out : Path
        Folder of all results; finished cases are kept.
    workers : int
        Number of processes.
    same_laws : bool
        Whether to repeat the rigs with the laws of the simulator.
    riddle : bool
        Whether to add the twelve rigs with a 280 Hz line for each seed.
    oracle_cases : int or None
        Number of rigs per seed with oracle, from the first on; None: all.
    duration : float
        Length of each recording [s].
    practice : Path or None
        Folder of recordings with known answers.
    """

    seeds: tuple[int, ...]
    cases: int
    out: Path
    workers: int = 1
    same_laws: bool = False
    riddle: bool = False
    oracle_cases: int | None = None
    duration: float = 12.0
    practice: Path | None = None

    @property
    def command(self) -> str:
        """Command that reproduces the results, without folders of this machine."""
        words = ["python -m proof", *(f"--seed {seed}" for seed in self.seeds), f"--cases {self.cases}"]
        words += ["--duration " + f"{self.duration:g}"] if self.duration != 12.0 else []
        words += [] if self.oracle_cases is None else [f"--oracle-cases {self.oracle_cases}"]
        flags = {"--same-laws": self.same_laws, "--riddle": self.riddle}
        words += [word for word, on in flags.items() if on]
        return " ".join(words)
