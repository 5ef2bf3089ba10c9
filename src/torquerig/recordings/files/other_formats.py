"""Formats that are not read, with the export that their program offers, and contents under another ending."""

from __future__ import annotations

from pathlib import Path

_EXPORTS = {
    ".d7d": "in DEWESoft, export it as MDF4, MATLAB or TDMS",
    ".dxd": "in DEWESoft, export it as MDF4, MATLAB or TDMS",
    ".dmd": "in DEWESoft, export it as MDF4, MATLAB or TDMS",
    ".bin": "a .bin of catman: in catman, export it as MATLAB, MDF4 or ASCII; another .bin: save it as .csv or .mat",
    ".tst": "in catman, export it as MATLAB, MDF4 or ASCII",
    ".uff": "universal file: export the time data as .mat or .csv in the program that wrote it",
    ".unv": "universal file: export the time data as .mat or .csv in the program that wrote it",
    ".mcap": "a log of Foxglove or ROS: export the signals as .csv or .parquet",
    ".bag": "a log of ROS: export the signals as .csv or .parquet",
    ".db3": "a log of ROS: export the signals as .csv or .parquet",
    ".xls": "the old Excel format: in Excel, save it as .xlsx or .csv",
    ".xlsm": "an Excel file with macros: in Excel, save it as .xlsx",
    ".xlsb": "the binary Excel format: in Excel, save it as .xlsx",
    ".ods": "a LibreOffice sheet: save it as .xlsx or .csv",
    ".tdm": "DIAdem's older pair of files: in DIAdem, save it as TDMS",
    ".tdx": "DIAdem's older pair of files: in DIAdem, save it as TDMS",
    ".tdms_index": "the index of a TDMS file: name the .tdms file next to it",
    ".raw": "imc: in FAMOS, export it as .mat, MDF4 or ASCII",
    ".asc": "a text export: rename it to .txt or .csv",
    ".blf": "a log of a CAN bus: in CANoe or CANalyzer, export the decoded signals as MDF4",
    ".sie": "nCode or HBM eDAQ: export it as MATLAB or ASCII",
    ".rpc": "MTS RPC III: export it as MATLAB or ASCII",
    ".slx": "a Simulink model, not a recording: save the logged signals as .mat",
    ".m": "a MATLAB program: save the signals as .mat",
    ".fig": "a MATLAB figure: save the signals as .mat",
    ".npy": "save the columns as .csv, .mat or .parquet",
    ".npz": "save the columns as .csv, .mat or .parquet",
    ".pkl": "save the columns as .csv, .mat or .parquet",
    ".feather": "save it as .parquet",
    ".arrow": "save it as .parquet",
    ".json": "save the columns as .csv",
    ".mp3": "a lossy sound format: record as .wav",
    ".flac": "save it as .wav",
    ".zip": "unpack it",
    ".7z": "unpack it",
    ".rar": "unpack it",
}


def export_for(ending: str) -> str:
    """Return what to do with a file of this ending, which is not read; empty where the ending is not known."""
    return _EXPORTS.get(ending.lower(), "")


# first bytes of a format, its name, and the endings under which it is read; the first one is the usual
_FIRST_BYTES = (
    (b"TDSm", "a TDMS file", (".tdms",)),
    (b"MATLAB 5.0 MAT-file", "a MATLAB file", (".mat",)),
    (b"MATLAB 7.3 MAT-file", "a MATLAB file", (".mat", ".h5", ".hdf5", ".hdf")),
    (b"\x89HDF\r\n\x1a\n", "an HDF5 file", (".h5", ".hdf5", ".hdf", ".mat")),
    (b"PAR1", "a Parquet file", (".parquet",)),
    (b"\x1f\x8b", "a file packed by gzip", (".csv.gz", ".gz")),
    (b"MDF     ", "an MDF file", (".mf4", ".mdf")),
    (b"LabVIEW Measurement", "an LVM file of LabVIEW", (".lvm",)),
)
# bytes that are read of a file, enough for each of the formats
_HEAD = 4096
_TEXT = bytes(range(0x20, 0x7F)) + b"\t\r\n"
_BINARY = (".tdms", ".parquet", ".xlsx", ".wav", ".h5", ".hdf5", ".hdf", ".mf4", ".mdf", ".mat", ".gz")


def other_content(path: Path) -> str:
    """Return what a file holds, and the ending to give it, where that is not what its ending says; else nothing.

    The first bytes decide. A text under the ending of a binary format is a text table.
    """
    with path.open("rb") as file:
        head = file.read(_HEAD)
    content, endings = _content(head.removeprefix(b"\xef\xbb\xbf"))
    ending = path.suffix.lower()
    if not content:
        is_text = b"\n" in head and not head.translate(None, _TEXT)
        content, endings = ("a text", (".csv",)) if is_text and ending in _BINARY else ("", ())
    if not content or ending in endings:
        return ""
    return f"its content is {content}; rename it to {path.stem}{endings[0]}"


def _content(head: bytes) -> tuple[str, tuple[str, ...]]:
    """Return what a file is by its first bytes, and its endings; nothing where they are not known."""
    for first, name, endings in _FIRST_BYTES:
        if head.startswith(first):
            return name, endings
    if head.startswith(b"RIFF") and head[8:12] == b"WAVE":
        return "a WAV file", (".wav",)
    if head.startswith(b"PK\x03\x04") and (b"xl/" in head or b"[Content_Types].xml" in head):
        return "an Excel workbook", (".xlsx",)
    return "", ()
