"""Recordings in and out: a table file, and beside it a sidecar of the same name with the ending ``.yaml``.

======================= ===========================================================================
``reading``             any file to a checked Recording; the table of endings
``writing``             a Recording to a file and its sidecar, whole or not at all
``stream``              a recording described but not read; ``blocks``: cut into overlapping blocks
``block_writing``       blocks to a file and its sidecar; ``mat_blocks``: to a .mat of v7.3
``pieces``              what a file holds, piece by piece; ``tdms_pieces``: TDMS with chunks of any size
``gaps``                where time jumps
``sidecar``             what the channels mean and the run they were taken in
``scale``               what one of a channel's units is in SI
``naming``              what a column means by its name alone, where there is no sidecar
``timebase``            the sample rate, from the sidecar, the file or a time column
``checks``              what no recording may have: missing samples, unequal lengths, not-a-number
``table``               columns as a format's reader hands them over
``delimited``           numbers in rows of text, with the line of a broken one
``parquet``, ``csv``    read and written
``mat``, ``tdms``       read and written
``text``, ``lvm``       read: the bare two-column table, the LabVIEW measurement text
``wav``                 read: shares of full scale
======================= ===========================================================================
"""

from torquerig.recordings.files.reading import read_recording
from torquerig.recordings.files.stream import open_stream
from torquerig.recordings.files.writing import check_target, write_recording

__all__ = ["check_target", "open_stream", "read_recording", "write_recording"]
