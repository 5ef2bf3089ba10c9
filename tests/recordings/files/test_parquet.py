"""Parquet files of other programs: moments as times, the index of pandas, units of fields, decimals, large integers."""

from datetime import datetime, timedelta
from decimal import Decimal
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pyarrow as pa
import pytest
from pyarrow import parquet

from torquerig.recordings.files import open_stream, read_recording
from torquerig.recordings.files.parquet import parquet_pieces, read_parquet

START = datetime(2024, 5, 1, 10)
TORQUE = np.sin(np.arange(300) / 7)


def both_ways(path: Path) -> Any:
    table, pieces = read_parquet(path), parquet_pieces(path)
    assert (pieces.names, pieces.units, pieces.skipped) == (tuple(table.columns), table.units, table.skipped)
    parts = list(pieces.pieces(pieces.names))
    for name, values in table.columns.items():
        assert np.array_equal(np.concatenate([part[name] for part in parts]), values)
    return table


@pytest.mark.parametrize("unit", ["ms", "us", "ns"])
@pytest.mark.parametrize("kind", [pa.timestamp, pa.duration])
def test_moments_are_times(tmp_path: Path, unit: str, kind: Any) -> None:
    steps = [timedelta(milliseconds=index) for index in range(300)]
    moments = pa.array([START + step for step in steps] if kind is pa.timestamp else steps, kind(unit))
    path = tmp_path / "run.parquet"
    parquet.write_table(pa.table({"timestamp": moments, "torque_Nm": TORQUE}), path, row_group_size=100)
    table = both_ways(path)
    np.testing.assert_allclose(table.columns["timestamp"], np.arange(300) / 1000, atol=1e-12)
    assert table.units == {"timestamp": "s"}
    assert (read_recording(path).sample_rate, open_stream(path).sample_rate) == (1000, 1000)


def test_the_index_of_pandas(tmp_path: Path) -> None:
    index = pd.to_datetime(START) + pd.to_timedelta(np.arange(300), unit="ms")
    pd.DataFrame({"torque_Nm": TORQUE}, index=index).to_parquet(tmp_path / "run.parquet")
    assert list(both_ways(tmp_path / "run.parquet").columns) == ["torque_Nm", "time"]
    assert read_recording(tmp_path / "run.parquet").sample_rate == 1000


def test_units_of_fields_and_other_kinds(tmp_path: Path) -> None:
    kinds = {
        "torque": pa.float32(),
        "on": pa.bool_(),
        "exact": pa.decimal128(8, 3),
        "big": pa.int64(),
        "word": pa.string(),
    }
    fields = [
        pa.field(name, kind, metadata={"unit": "Nm"} if name == "torque" else None) for name, kind in kinds.items()
    ]
    rows = [[1.5, 2.5], [True, None], [Decimal("1.25"), Decimal("2.5")], [2**62 + 1, 7], ["a", "b"]]
    arrays = [pa.array(row, one.type) for row, one in zip(rows, fields, strict=True)]
    parquet.write_table(pa.Table.from_arrays(arrays, schema=pa.schema(fields)), tmp_path / "run.parquet")
    table = read_parquet(tmp_path / "run.parquet")
    assert table.units == {"torque": "Nm"}
    assert table.columns["exact"].tolist() == [1.25, 2.5]
    assert table.columns["big"].tolist() == [2.0**62, 7]
    assert table.columns["on"][0] == 1
    assert np.isnan(table.columns["on"][1])
    assert table.skipped == {"word": "values of the type string"}


@pytest.mark.parametrize("name", ["ts", "Moment", "date"])
def test_the_only_column_of_moments_is_the_time(tmp_path: Path, name: str) -> None:
    moments = [START + timedelta(milliseconds=index) for index in range(300)]
    parquet.write_table(pa.table({name: moments, "torque_Nm": TORQUE}), tmp_path / "run.parquet")
    table = both_ways(tmp_path / "run.parquet")
    assert list(table.columns) == ["time_s", "torque_Nm"]
    assert f"{name} is called time_s" in table.notes
    assert open_stream(tmp_path / "run.parquet").sample_rate == 1000
