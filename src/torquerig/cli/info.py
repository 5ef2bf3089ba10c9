"""``torquerig info``: what is in a recording."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.plain_table import grid
from torquerig.signals.files import read_recording, recording_info


@click.command("info")
@click.argument("recording", type=click.Path(path_type=Path))
def command(recording: Path) -> None:
    """Show channels, rate, length and levels of RECORDING, and what looks suspicious."""
    made = read_recording(recording)
    info = recording_info(made)
    click.echo(f"{recording}: {made.samples} samples at {made.sample_rate:g} Hz, {made.duration:g} s")
    rows = [["channel", "quantity", "unit", "minimum", "mean", "maximum", "std"]]
    for name, channel in made.channels.items():
        values = channel.values
        rows.append([name, channel.quantity, channel.unit, *(f"{number:.6g}" for number in (
            values.min(), values.mean(), values.max(), values.std()))])  # fmt: skip
    click.echo(grid(rows))
    for suspicion in info.suspicions():
        click.echo(f"suspicious: {suspicion}")
