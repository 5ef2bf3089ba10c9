"""``python -m proof.null --seed N ... --cases K --out FOLDER``: detection thresholds of a scenario, from clean rigs.

It uses only the rigs of ``python -m proof`` without hidden effects, and takes a fifth of the time.
"""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from pathlib import Path

import click
import yaml

from proof.errors import ProofError
from proof.null_gains import as_rows, from_rows, null_gains
from proof.prove.diagnosing import nominal_scenario, read_all, write_json
from proof.prove.jobs import run_jobs
from proof.rig_program.draw import Case, answer_of, record_case
from proof.thresholds import FEWEST, as_table, thresholds
from proof.trials import draw_trials
from torquerig.diagnosis.judging.share_explained import LEAST_SHARE
from torquerig.diagnosis.null_table import content_key

RECORDINGS, GAINS, TABLE = "recordings", "gains", "null_table.yaml"


@dataclass(frozen=True)
class NullJob:
    """One clean rig of a seed, and the folder of all."""

    case: Case
    folder: Path

    @property
    def gains(self) -> Path:
        """Path of the gains."""
        return self.folder / GAINS / f"{self.case.name}.json"


@click.command()
@click.option(
    "--seed",
    "seeds",
    type=click.IntRange(0),
    multiple=True,
    required=True,
    help="seed of rigs that no trial scores; can be repeated",
)
@click.option("--cases", type=click.IntRange(1), default=80, show_default=True, help="number of rigs per seed")
@click.option(
    "--out", type=click.Path(path_type=Path), required=True, help="folder of all results; finished cases are kept"
)
@click.option("--workers", type=click.IntRange(1), default=2, show_default=True, help="number of processes")
def main(seeds: tuple[int, ...], cases: int, out: Path, *, workers: int) -> None:
    """Fit the library to rigs without hidden effects, and write the detection thresholds."""
    jobs = [job for seed in seeds for job in clean_jobs(seed, cases, out / f"seed-{seed}")]
    if len(jobs) < FEWEST:
        raise ProofError(f"{len(jobs)} clean rigs are too few for thresholds; make at least {FEWEST}")
    remaining = [job for job in jobs if not job.gains.is_file()]
    run_jobs(
        gained, remaining, workers=workers, progress=lambda done, all_, name: click.echo(f"{done} of {all_} {name}")
    )
    scenario = nominal_scenario()
    rigs = [from_rows(yaml.safe_load(job.gains.read_text(encoding="utf-8"))) for job in jobs]
    options = [part for seed in seeds for part in ("--seed", str(seed))]
    entry = as_table(
        thresholds(rigs, least_share=LEAST_SHARE), key=content_key(scenario), title=scenario.title, seeds=seeds,
        command=shlex.join(["python", "-m", "proof.null", *options, "--cases", str(cases)]), clean_rigs=len(rigs),
    )  # fmt: skip
    (out / TABLE).write_text(yaml.safe_dump({"tables": [entry]}, sort_keys=False), encoding="utf-8")
    click.echo(f"{out / TABLE}: {len(rigs)} clean rigs")


def clean_jobs(seed: int, cases: int, folder: Path) -> list[NullJob]:
    """Return the rigs of a seed without hidden effects."""
    return [NullJob(case, folder) for case in draw_trials(seed, cases) if answer_of(case)["verdict"] == "adequate"]


def gained(job: NullJob) -> str:
    """Record one rig, write the gain of each mechanism of the library, and return the name of the rig."""
    record_case(job.case, job.folder / RECORDINGS)
    recordings = read_all(sorted((job.folder / RECORDINGS / job.case.name).glob("*.parquet")))
    write_json(job.gains, as_rows(null_gains(nominal_scenario(), recordings)))
    return job.case.name


if __name__ == "__main__":
    main()
