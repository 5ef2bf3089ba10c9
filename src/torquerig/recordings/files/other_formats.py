"""Formats of measuring programs that are not read, and the export that their program offers."""

from __future__ import annotations

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
