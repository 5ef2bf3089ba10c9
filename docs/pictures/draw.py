"""The two pictures of the README, from the tool's own output: python docs/pictures/draw.py [RUN.parquet AFTER.parquet].

Without files the script makes them first, as a user would:
torquerig simulate scenarios/wear_rig.yaml --duration "6 s" --truth --out run.parquet
torquerig filter run.parquet --chain order_lines --out after.parquet
"""

from __future__ import annotations

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib as mpl
import numpy as np
from matplotlib import pyplot as plt

from torquerig.cli import main
from torquerig.recordings.files import read_recording

HERE = Path(__file__).resolve().parent
STYLE = {
    "font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "svg.hashsalt": "torquerig",
    "svg.fonttype": "none",
    "font.sans-serif": ["DejaVu Sans", "Arial", "Helvetica"],
}  # fmt: skip
SHOWN = (2.0, 2.6)  # [s] two turns of the output shaft
LINES = {1: ("output shaft", "left"), 30: ("cogging", "right"), 35: ("electrical", "left")}  # order: cause, side


def recordings(folder: Path) -> tuple[Path, Path]:
    """Simulate and filter the wear rig; return both files."""
    run, after = folder / "run.parquet", folder / "after.parquet"
    scenario = HERE.parents[1] / "scenarios" / "wear_rig.yaml"
    main(("simulate", str(scenario), "--duration", "6 s", "--truth", "--out", str(run)))
    main(("filter", str(run), "--chain", "order_lines", "--out", str(after)))
    return run, after


def draw(run: Path, after: Path) -> None:
    """Write torque.svg and orders.svg beside this script."""
    measured, filtered = read_recording(run), read_recording(after)
    time = np.arange(measured.samples) / measured.sample_rate
    reading, clean = (one.channels["torque_V"].values for one in (measured, filtered))
    load = measured.channels["true_load_Nm"].values
    turns = measured.channels["true_motor_angle_rad"].values / (2 * np.pi) / 5

    figure, axes = plt.subplots(figsize=(6.4, 2.2), layout="constrained")
    keep = slice(*(round(moment * measured.sample_rate) for moment in SHOWN), 25)
    axes.plot(time[keep], reading[keep], color="#9aa5b1", lw=0.7, label="sensor reading (1 V is 1 N m)")
    axes.plot(time[keep], clean[keep], color="#12395b", lw=1.0, label="after the filter order_lines")
    axes.plot(time[keep], load[keep], color="#d95f02", lw=1.0, label="true load")
    axes.set(xlabel="time [s]", ylabel="torque [N m]", xlim=SHOWN)
    axes.legend(frameon=False, fontsize=7, ncols=3, loc="upper center", bbox_to_anchor=(0.5, 1.22))
    figure.savefig(HERE / "torque.svg", metadata={"Date": None})

    even = np.arange(turns[0], turns[-1], 1 / 400)  # orders up to 200
    figure, axes = plt.subplots(figsize=(6.4, 2.2), layout="constrained")
    for values, colour, label in (
        (reading, "#9aa5b1", "sensor reading"),
        (clean, "#12395b", "after the filter order_lines"),
    ):
        over_angle = np.interp(even, turns, values - values.mean())
        window = np.hanning(even.size)
        amplitude = 2 * np.abs(np.fft.rfft(over_angle * window)) / window.sum()
        orders = np.fft.rfftfreq(even.size, 1 / 400)
        shown = (orders >= 0.5) & (orders <= 80)
        axes.semilogy(orders[shown], amplitude[shown], color=colour, lw=0.7, label=label)
        if colour == "#9aa5b1":
            for order, (cause, side) in LINES.items():
                height = amplitude[np.argmin(np.abs(orders - order))]
                axes.annotate(f"{cause} {order}", (order, height), (order, height * 1.3), fontsize=7, ha=side)
    axes.set(xlabel="order of the output shaft [1/rev]", ylabel="amplitude [N m]", ylim=(1e-4, 0.6), xlim=(0, 80))
    axes.legend(frameon=False, fontsize=7, loc="upper right")
    figure.savefig(HERE / "orders.svg", metadata={"Date": None})


if __name__ == "__main__":
    mpl.rcParams.update(STYLE)
    if len(sys.argv) == 3:
        draw(Path(sys.argv[1]), Path(sys.argv[2]))
    else:
        with TemporaryDirectory() as folder:
            draw(*recordings(Path(folder)))
