"""Reading and writing of recordings: a table file, and a sidecar of the same name with the ending ``.yaml``.

======================= ===========================================================================
``reading``             reads any file into a checked Recording; the table of endings
``writing``             writes a Recording and its sidecar, both complete or none
``stream``              a long recording that is read block by block; ``blocks``: overlapping blocks
``block_writing``       writes blocks to a file and its sidecar; ``mat_blocks``: to a .mat of v7.3
``gaps``                steps of time that are not one sample long
``timebase``            the sample rate, from the sidecar, the file or a time column
``timing``              the sampling that times show: even, coarse, late, with gaps; ``time_band``, ``time_ticks``
``time_unit``           the unit of times that state none
``rate_changes``        stretches of one file at different rates; ``long_format``: channels mixed in one column
``starts``              channels that start later than the first
``several_times``       several columns of times in one table: whose they are, and which are the same
``checks``              refuses missing samples, unequal lengths, not-a-number
``sidecar``             reads the meaning of the channels and the test conditions
``sidecar_schema``      the keys of a sidecar with their bounds; ``sidecar_text``: writes a sidecar
``set_point_text``      the points of a profile in a sidecar, read and written
``scale``               the SI value of a channel's unit
``plain_names``         units taken out of the header cells, times in seconds
``number_table``        columns of numbers as a format's reader returns them
``table_pieces``        the same, piece by piece; ``tdms_pieces``: TDMS with chunks of any size
``text_tables``         text tables in the dialects of loggers, Excel and MATLAB
``parquet``, ``csv``    read and written; ``parquet_columns``: which columns are numbers
``mat``, ``tdms``       read and written; ``matlab``: what a .mat file of each version holds
``gz``, ``xlsx``        read: compressed text tables, Excel workbooks
``lvm``                 read: the LabVIEW measurement text; its segments, rows and rates are in ``lvm_parts``
``wav``                 read: shares of full scale
``hdf5``, ``mdf``       read: plain datasets; MDF4 through asammdf
``other_formats``       the export to choose for formats that are not read; contents under another ending
``child_reading``       reading in a process of its own, for libraries that a damaged file can bring down
======================= ===========================================================================
"""

from torquerig.recordings.files.reading import read_recording
from torquerig.recordings.files.stream import open_stream
from torquerig.recordings.files.writing import check_target, write_recording

__all__ = ["check_target", "open_stream", "read_recording", "write_recording"]
