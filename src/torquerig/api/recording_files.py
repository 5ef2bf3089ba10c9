"""``read`` and ``write``: recordings from and to files."""

from __future__ import annotations

from pathlib import Path

from torquerig.recordings.files import read_recording, write_recording
from torquerig.recordings.recording import Recording


def read(path: str | Path) -> Recording:
    r"""Return the recording in a file.

    Parameters
    ----------
    path : str or Path
        Parquet, CSV, MATLAB, TDMS, LVM, WAV or two-column text, by its ending; a sidecar of the same name with the
        ending ``.yaml`` states what the columns mean. Other installed packages may add formats.

    Returns
    -------
    Recording
        Equally sampled channels with units; frozen.

    Raises
    ------
    InputError, RecordingError
        With the file and a remedy.

    Examples
    --------
    >>> import tempfile, pathlib, torquerig as tr
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> _ = (folder / "run.csv").write_text("time_s,torque_Nm\n0,1\n0.001,2\n0.002,3\n")
    >>> run = tr.read(folder / "run.csv")
    >>> round(run.sample_rate), run.torque().tolist()
    (1000, [1.0, 2.0, 3.0])
    """
    return read_recording(Path(path))


def write(recording: Recording, path: str | Path, *, overwrite: bool = False) -> tuple[Path, ...]:
    """Write a recording and its sidecar, both whole or neither, and return their paths.

    Parameters
    ----------
    recording : Recording
    path : str or Path
        With the ending .parquet, .csv, .mat or .tdms.
    overwrite : bool
        Whether a file of that name may be replaced.

    Raises
    ------
    InputError
        For another ending, a missing folder, or a file that may not be replaced.

    Examples
    --------
    >>> import tempfile, pathlib, torquerig as tr
    >>> rec = tr.simulate("wear_rig.yaml", duration=0.2)
    >>> [path.name for path in tr.write(rec, pathlib.Path(tempfile.mkdtemp()) / "run.parquet")]
    ['run.parquet', 'run.yaml']
    """
    return tuple(write_recording(recording, Path(path), overwrite=overwrite))
