"""CPU time of reading an LVM file of about 50 MB: ``python benchmarks/lvm.py [X_COLUMNS] [ROWS]``.

Measured on 2 shared cores, Python 3.11, 1.1 million rows of 4 channels (54, 86 and 44 MB for One, Multi and No), first
import included: 1.4, 2.3 and 1.2 s; before the body was read by columns 7.7, 9.0 and 6.2 s; lvm_read 1.26 4.1 s (One).
"""

from __future__ import annotations

import sys
import tempfile
import time
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from torquerig.recordings.files.lvm import read_lvm

CHANNELS = 4


def write(path: Path, *, x_columns: str, rows: int) -> None:
    """Write a file as LabVIEW does, with CR LF and six decimals."""
    gap = "\t\t" if x_columns == "Multi" else "\t"
    head = ["LabVIEW Measurement\t", "Separator\tTab", "Decimal_Separator\t.", f"X_Columns\t{x_columns}",
            "***End_of_Header***\t", "\t", f"Channels\t{CHANNELS}",
            *(f"{tag}\t" + gap.join([cell] * CHANNELS) for tag, cell in
              (("Samples", str(rows)), ("Y_Unit_Label", "Volts"), ("X_Dimension", "Time"), ("Delta_X", "4.0E-5"))),
            "***End_of_Header***\t"]  # fmt: skip
    names = [f"Voltage_{index}" for index in range(CHANNELS)]
    label = "X_Value\t" + ("\tX_Value\t" if x_columns == "Multi" else "\t").join(names) + "\tComment"
    values = np.random.default_rng(1).standard_normal((1000, CHANNELS))
    with path.open("w", newline="\r\n") as file:
        file.write("\n".join([*head, label]) + "\n")
        for row in range(rows):
            x, numbers = f"{row * 4e-5:.6f}", [f"{value:.6f}" for value in values[row % 1000]]
            cells = (
                [x, f"\t{x}\t".join(numbers)] if x_columns == "Multi" else [x if x_columns == "One" else "", *numbers]
            )
            file.write("\t".join(cells) + "\n")


def main(x_columns: str = "One", rows: str = "1100000") -> None:
    """Write, read and print."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "run.lvm"
        write(path, x_columns=x_columns, rows=int(rows))
        print(f"{path.stat().st_size / 1e6:.0f} MB, X_Columns {x_columns}")
        begin = time.process_time()
        table = read_lvm(path)
        samples = sum(one.size for one in table.columns.values())
        print(f"torquerig: {time.process_time() - begin:.2f} s CPU, {samples} samples")
        if find_spec("lvm_read"):
            import lvm_read

            begin = time.process_time()
            lvm_read.read(str(path), read_from_pickle=False, dump_file=False)
            print(f"lvm_read:  {time.process_time() - begin:.2f} s CPU")


if __name__ == "__main__":
    main(*sys.argv[1:])
