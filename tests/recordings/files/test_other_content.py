"""Files under the ending of another format: what they are, and the ending to give them."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from torquerig.errors import InputError
from torquerig.recordings.files import open_stream, read_recording, write_recording
from torquerig.recordings.recording import Channel, Recording

ENDINGS = (".csv", ".mat", ".tdms", ".parquet", ".lvm", ".h5", ".xlsx", ".wav")
NAMES = {".mat": "a MATLAB file", ".tdms": "a TDMS file", ".parquet": "a Parquet file", ".csv": "a text"}


def recording() -> Recording:
    values = 2 + np.sin(np.arange(200) / 9)
    return Recording(sample_rate=1000.0, channels={"torque_Nm": Channel(values=values, quantity="torque", unit="N*m")})


@pytest.mark.parametrize("content", list(NAMES))
@pytest.mark.parametrize("ending", ENDINGS)
def test_the_first_bytes_show_another_format(tmp_path: Path, content: str, ending: str) -> None:
    if ending == content or (content == ".csv" and ending == ".lvm"):
        return
    made = tmp_path / f"made{content}"
    write_recording(recording(), made)
    path = tmp_path / f"run{ending}"
    shutil.copyfile(made, path)
    for opened in (read_recording, open_stream):
        with pytest.raises(InputError, match=f"its content is {NAMES[content]}; rename it to run{content}$"):
            opened(path)
    path.rename(path.with_suffix(content))
    made.with_suffix(".yaml").rename(path.with_suffix(".yaml"))
    assert read_recording(path.with_suffix(content)).samples == 200


@pytest.mark.parametrize("ending", [".csv", ".txt", ".tdms", ".log"])
def test_an_lvm_text_is_known_by_its_first_line(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"run{ending}"
    path.write_bytes(b"LabVIEW Measurement\t\nSeparator\tTab\n***End_of_Header***\t\n")
    with pytest.raises(InputError, match=r"an LVM file of LabVIEW; rename it to run\.lvm"):
        read_recording(path)


def test_content_of_an_unknown_ending_is_known(tmp_path: Path) -> None:
    (tmp_path / "run.bak").write_bytes(b"TDSm" + bytes(40))
    with pytest.raises(InputError, match=r"a TDMS file; rename it to run\.tdms"):
        read_recording(tmp_path / "run.bak")
