"""REAL: the command on recordings of five real benches, next to what is known of them; no recording is shipped."""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

import numpy as np

from proof.referee.claims import Claim, read_claim
from proof.referee.diagnosing import DIAGNOSES, REFUSED, DiagnoseJob, diagnosed, is_diagnosed
from proof.referee.making import RECORDINGS
from torquerig.recordings.files import write_recording
from torquerig.recordings.recording import Channel, Recording

SCENARIOS = Path(__file__).resolve().parents[1] / "real"
ODRIVE_CONSTANT, ODRIVE_COUNTS, ODRIVE_RATE = 0.0075, 8192, 10.0  # [N m/A], per turn, [Hz] of the standstill maps
PLAY_RATE = 20.0  # [Hz] of the points of the play tests


@dataclass(frozen=True)
class Bench:
    """A real bench: its folder, its recordings, one of whose names must be found, and what else is known of it."""

    name: str
    folder: str
    recordings: Callable[[Path], Sequence[Recording]]
    expected: tuple[str, ...]
    known: str


def real_lines(root: Path, out: Path, *, limit: float, options: tuple[str, ...], label: str = "") -> Iterator[str]:
    """Diagnose every bench whose folder is there, and yield a line about each."""
    for bench in BENCHES:
        if not (root / bench.folder).is_dir():
            yield f"REAL {bench.name}: no folder {bench.folder}"
            continue
        job = DiagnoseJob(f"real-{bench.name}", out, limit=limit, options=options, label=label)
        if not is_diagnosed(job):
            _write(bench, root, out / RECORDINGS / job.name)
            diagnosed(job)
        yield _line(bench, job)


def _write(bench: Bench, root: Path, folder: Path) -> None:
    if folder.exists():
        shutil.rmtree(folder)
    folder.mkdir(parents=True)
    for number, recording in enumerate(bench.recordings(root), start=1):
        write_recording(recording, folder / f"run{number}.parquet")
    shutil.copy(SCENARIOS / f"{bench.name}.yaml", folder / "scenario.yaml")


def _line(bench: Bench, job: DiagnoseJob) -> str:
    said = job.results / DIAGNOSES / f"{job.name}.json"
    if not said.is_file():
        why = (job.results / REFUSED / f"{job.name}.txt").read_text(encoding="utf-8").strip().splitlines()
        return f"REAL {bench.name}: no answer: {why[-1][:200] if why else ''}"
    claim = read_claim(said)
    names = [finding.name for finding in claim.findings]
    found = [name for name in bench.expected if name in names]
    return (
        f"REAL {bench.name}: {claim.verdict}, {', '.join(names) or 'no name'}; found {len(found)} of "
        f"{len(bench.expected)} ({', '.join(bench.expected)}); {_residual(claim, said)}; known: {bench.known}"
    )


def _residual(claim: Claim, said: Path) -> str:
    metric = (json.loads(said.read_text(encoding="utf-8")).get("fit") or {}).get("metric", "")
    if claim.rms_before is not None:
        return f"rms {claim.rms_before:.4g} -> {claim.rms_after:.4g} N*m"
    return f"held-out {claim.before} -> {claim.after} ({metric[:60]})"


def _public(module: str) -> Callable[[Path], Sequence[Recording]]:
    """Return the reader of a bench of `proof.real`, which finds its folder by an environment variable."""

    def recordings(root: Path) -> Sequence[Recording]:
        from proof.real.public import VARIABLE

        before = os.environ.get(VARIABLE)
        os.environ[VARIABLE] = str(root)
        try:
            answer: Sequence[Recording] = import_module(f"proof.real.{module}").recordings()
        finally:
            if before is None:
                del os.environ[VARIABLE]
            else:
                os.environ[VARIABLE] = before
        return answer

    return recordings


def _odrive(root: Path) -> Sequence[Recording]:
    return [_odrive_map(root / "odrive-cogging" / f"{name}.csv") for name in ("map_a16", "map_b16")]


def _odrive_map(path: Path) -> Recording:
    data = np.genfromtxt(path, delimiter=",", names=True)
    channels = {
        "Iq_A": Channel(values=data["Iq_A"], quantity="motor_torque", unit="A", si_per_unit=ODRIVE_CONSTANT),
        "angle_rad": Channel(
            values=data["pos_count"] * 2.0 * np.pi / ODRIVE_COUNTS, quantity="motor_angle", unit="rad"
        ),
    }
    return Recording(sample_rate=ODRIVE_RATE, channels=channels, name=path.stem)


def _cycloidal(root: Path) -> Sequence[Recording]:
    return [_play(root / "cycloidal-play" / f"play{i}.csv") for i in range(1, 6)]


def _play(path: Path) -> Recording:
    data = np.genfromtxt(path, delimiter=",", names=True)
    channels = {
        "torque_Nm": Channel(values=data["motor_torque_Nm"], quantity="torque", unit="N*m"),
        "deflection_rad": Channel(values=np.deg2rad(data["deflection_deg"]), quantity="angle", unit="rad"),
    }
    return Recording(sample_rate=PLAY_RATE, channels=channels, name=path.stem)


BENCHES = (
    Bench("emps", "emps", _public("emps"), ("stribeck_friction",), "dry friction that differs by direction"),
    Bench("laas", "laas-cogging", _public("laas"), ("cogging",), "cogging of order 72, friction by direction"),
    Bench("brfd", "brfd-backlash", _public("brfd"), ("stribeck_friction", "backlash"), "play of 3.2 mm, presliding"),
    Bench("odrive", "odrive-cogging", _odrive, ("cogging",), "orders 12 k, 14 k, 84; order 7 has no name"),
    Bench("cycloidal", "cycloidal-play", _cycloidal, ("backlash",), "play of 0.5 to 0.8 deg, dry friction"),
)
