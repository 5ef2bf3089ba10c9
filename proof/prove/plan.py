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
    alone : bool
        No oracle, no gains of clean rigs.
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
    alone: bool = False
    duration: float = 12.0
    practice: Path | None = None
    real: Path | None = None

    @property
    def command(self) -> str:
        """The command that makes the same again, without any folder of this machine."""
        words = ["torquerig prove", *(f"--seed {seed}" for seed in self.seeds), f"--cases {self.cases}"]
        words += ["--duration " + f"{self.duration:g}"] if self.duration != 12.0 else []
        flags = {"--same-laws": self.same_laws, "--riddle": self.riddle, "--alone": self.alone}
        words += [word for word, on in flags.items() if on]
        return " ".join(words)
