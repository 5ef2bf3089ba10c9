"""Filters on a block of rows against one row after the other: processor time of a row of 2 s at 25 kHz.

Run: python benchmarks/rows_at_once.py
"""

import time

import numpy as np
from scipy.signal import butter, oaconvolve, sosfiltfilt

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.filters.chains.chain_file import read_chains
from torquerig.orders.angle.best_angle import best_motor_angle
from torquerig.scenario.kinematics import kinematics_of
from torquerig.scenario.overrides import overridden
from torquerig.scenario.reading import ScenarioReader
from torquerig.simulation.batch import simulate_batch

ROWS, SAMPLES, RATE, TURNS = 8, 50_000, 25_000.0, 25
low_pass = butter(4, 20.0, fs=RATE, output="sos")
window = np.hanning(2001) / np.hanning(2001).sum()
block = np.random.default_rng(0).standard_normal((ROWS, SAMPLES))


def least(work) -> float:
    """Return the least processor time of a row [ms]."""
    work()
    spent = []
    for _ in range(TURNS):
        start = time.process_time()
        work()
        spent.append(time.process_time() - start)
    return 1e3 * min(spent) / ROWS


for name, one in {
    "Butterworth, forwards and backwards": lambda rows: sosfiltfilt(low_pass, rows, padlen=1250),
    "transform and back": lambda rows: np.fft.irfft(np.fft.rfft(rows), SAMPLES),
    "FIR by overlap-add": lambda rows: oaconvolve(rows, window if rows.ndim == 1 else window[None], axes=-1),
}.items():
    single, whole = least(lambda one=one: [one(row) for row in block]), least(lambda one=one: one(block))
    print(f"{name:37s} row by row {single:.2f} ms a row, {ROWS} rows at once {whole:.2f}")

document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), ["rig.motor.catalog=HDS6A-0104A"])
reader = ScenarioReader(document, load_catalog(shipped_folder()))
rigs = [reader.at(seed).rig for seed in range(ROWS)]
readings = simulate_batch(rigs, seeds=[1] * ROWS, duration=SAMPLES / RATE)
filters = [
    read_chains(shipped_scenarios() / "filters.yaml", kinematics=kinematics_of(rig))["order_lines"].stages[0]
    for rig in rigs
]
pairs = list(zip(filters, readings, strict=True))
print(f"weighted lines {least(lambda: [stage.apply(reading) for stage, reading in pairs]):.2f} ms a row")
first = best_motor_angle(readings[0], filters[0].lines).values
same = sum(np.array_equal(first, best_motor_angle(reading, stage.lines).values) for stage, reading in pairs)
print(f"rows of one motor with the measured angle of the first: {same} of {ROWS}")
