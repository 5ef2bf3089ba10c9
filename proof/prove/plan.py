"""What a proof is asked for."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, kw_only=True)
class Plan:
    """Which trials, where to, and how many at a time.

    Parameters
    ----------
    seeds : tuple of int
    cases : int
        Of each seed.
    out : Path
        Folder of everything; what is there already is not made again.
    workers : int
        Processes.
    same_laws : bool
        The same rigs once more with the reference's own laws.
    riddle : bool
        The twelve rigs of the 280 Hz riddle for each seed.
    oracle_cases : int or None
        How many rigs of each seed, from the first on, get an oracle or the gains of clean rigs; None: all of them.
    duration : float
        Of each run [s].
    practice, real : Path or None
        Folders of recordings with known answers.
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
    real: Path | None = None

    @property
    def command(self) -> str:
        """The command that makes the same again, without any folder of this machine."""
        words = ["python -m proof", *(f"--seed {seed}" for seed in self.seeds), f"--cases {self.cases}"]
        words += ["--duration " + f"{self.duration:g}"] if self.duration != 12.0 else []
        words += [] if self.oracle_cases is None else [f"--oracle-cases {self.oracle_cases}"]
        flags = {"--same-laws": self.same_laws, "--riddle": self.riddle}
        words += [word for word, on in flags.items() if on]
        return " ".join(words)
