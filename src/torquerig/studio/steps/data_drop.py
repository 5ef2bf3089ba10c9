"""The place for dropped files, and the address that receives them."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from nicegui import app, ui
from starlette.requests import Request
from starlette.responses import PlainTextResponse

from torquerig.errors import InputError
from torquerig.studio.data.received import received

ADDRESS = "/studio/drop"
_FOLDERS: list[Path] = []  # of the studio of this process: it has one


class DropPlace(ui.element, component="page/data_drop.js"):
    """Takes files of a person and writes them into the folder.

    Parameters
    ----------
    folder : Path
        Of the studio.
    on_received : callable
        Called with a mapping for each file: ``name``, ``ok``, ``text``.
    """

    def __init__(self, folder: Path, on_received: Callable[[Sequence[Mapping[str, Any]]], Awaitable[None]]) -> None:
        super().__init__()
        _receive_into(folder)
        self.props["address"] = ADDRESS
        self.on("received", lambda event: on_received(event.args))


def _receive_into(folder: Path) -> None:
    if not _FOLDERS:
        app.add_route(ADDRESS, _answer, methods=["POST"])
    _FOLDERS[:] = [folder]


async def _answer(request: Request) -> PlainTextResponse:
    try:
        path = await received(_FOLDERS[0], request.query_params.get("name", ""), request.stream())
    except InputError as error:
        return PlainTextResponse(str(error), status_code=409)
    return PlainTextResponse(path.name)
