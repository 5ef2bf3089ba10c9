"""Which sidecar belongs to a recording, where several files share a name."""

from __future__ import annotations

from collections.abc import Callable, Collection
from pathlib import Path

from torquerig.document import parse_document, read_document
from torquerig.recordings.files.sidecar import Sidecar, read_sidecar, sidecar_from, sidecar_path
from torquerig.recordings.names.header import split_header
from torquerig.recordings.recording import Recording

_NO_RECORDINGS = (".yaml", ".yml", ".json", ".svg", ".png", ".pdf", ".html", ".md", ".partial")


def own_sidecar_path(recording: Path) -> Path:
    """Return the path of a sidecar for this format alone: ``run.csv.yaml`` for ``run.csv``."""
    return recording.with_name(f"{recording.name}.yaml")


def sidecar_target(recording: Path) -> Path:
    """Return where the sidecar of a recording is written.

    That is ``run.yaml``, or ``run.csv.yaml`` where there is one already, or where ``run.yaml`` belongs to a recording
    of the same name in another format.
    """
    own, common = own_sidecar_path(recording), sidecar_path(recording)
    return own if own.exists() or (common.exists() and namesakes(recording)) else common


def find_sidecar(recording: Path) -> Path | None:
    """Return the sidecar file of a recording by its name: ``run.csv.yaml`` before ``run.yaml``, or None."""
    own, common = own_sidecar_path(recording), sidecar_path(recording)
    return own if own.is_file() else common if common.is_file() else None


def sidecar_of(
    recording: Path, columns: Callable[[], Collection[str]], *, embedded: str = ""
) -> tuple[Sidecar | None, tuple[str, ...]]:
    """Return the sidecar of a recording, or None, and a note where one of its name belongs to another file.

    ``run.yaml`` belongs to ``run.csv``, unless there is also a ``run.mat`` and the sidecar names columns that are not
    in ``run.csv``.

    Parameters
    ----------
    columns : callable
        Returns the columns of the recording as the file writes them; called only where files share a name.
    embedded : str
        The sidecar that the file itself holds; it counts where there is no other.

    Raises
    ------
    InputError
        A sidecar that cannot be read.
    """
    path = find_sidecar(recording)
    if path is None:
        return _embedded(recording, embedded)
    sidecar = read_sidecar(path)
    others = namesakes(recording) if path == sidecar_path(recording) else []
    if not others:
        return sidecar, ()
    written = list(columns())
    known = {*written, *(split_header(cell)[0] for cell in written)}
    foreign = [name for name in sidecar.channels if name not in known]
    if not foreign:
        return sidecar, ()
    note = (
        f"{path.name} names {foreign[0]}, which is not in {recording.name}, and is taken for that of {others[0].name}; "
        f"a sidecar for {recording.name} alone is called {own_sidecar_path(recording).name}"
    )
    return None, (note,)


def place_in_sidecar(recording: Recording, *keys: str) -> str:
    """Return file, line and keys of an entry in the sidecar of a recording; its name where there is no such file."""
    path = None if recording.path is None else find_sidecar(recording.path)
    written = ".".join(keys)
    if path is None:
        return f"{recording.name}: {written}"
    return read_document(path).place(keys)


def _embedded(recording: Path, text: str) -> tuple[Sidecar | None, tuple[str, ...]]:
    if not text:
        return None, ()
    return sidecar_from(parse_document(text, recording)), (f"the sidecar is that in {recording.name} itself",)


def namesakes(recording: Path) -> list[Path]:
    """Return the other files of the folder that may be recordings and would have the same sidecar."""
    common = sidecar_path(recording)
    if not recording.parent.is_dir():
        return []
    return sorted(
        one
        for one in recording.parent.glob(f"{_escaped(common.stem)}.*")
        if one != recording and one.suffix.lower() not in _NO_RECORDINGS and sidecar_path(one) == common
    )


def _escaped(stem: str) -> str:
    return "".join(f"[{sign}]" if sign in "[]*?" else sign for sign in stem)
