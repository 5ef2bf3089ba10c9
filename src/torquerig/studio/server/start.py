"""A studio from its start to Ctrl-C: lock, port, address, server."""

from __future__ import annotations

import asyncio
import secrets
import signal
import socket
from collections.abc import Callable, Sequence
from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from torquerig.errors import InputError
from torquerig.studio.server.compute import Compute
from torquerig.studio.session.studio_lock import studio_lock

if TYPE_CHECKING:
    from types import FrameType

    from torquerig.studio.server.step import Step
    from torquerig.studio.server.tabs import Tabs

HOST = "127.0.0.1"
CONNECTED = 60.0  # [s] in which a page that was loaded opens its websocket, on the busiest machine
LISTENS = 0.01  # [s] between two attempts to connect to a port that does not listen yet
EXTRA = "pip install 'torquerig[studio]'"
HEAD = """<link rel="stylesheet" href="/studio/report/page.css">
<link rel="stylesheet" href="/studio/page/studio.css">
<script defer src="/studio/bokeh/bokeh.min.js"></script>
<script defer src="/studio/report/scripts/pyramid.js"></script>
<script defer src="/studio/page/keys.js"></script>
<script>const studioScripts = new Promise((done) => addEventListener("load", done));
document.documentElement.lang = "en";
addEventListener("DOMContentLoaded", () => document.body.classList.add("studio"));</script>"""


def refuse_missing_extra() -> None:
    """Raise InputError where the packages of the studio are not installed."""
    if find_spec("nicegui") is None:
        raise InputError(f"the studio needs a package that is not installed; run {EXTRA}")


def _as_ctrl_c(number: int, frame: FrameType | None) -> None:
    """End by SIGTERM as by Ctrl-C, so that the computing process ends too."""
    raise KeyboardInterrupt


def free_port(port: int | None) -> int:
    """Return the port, or a free one where none is given; InputError where another program uses it."""
    with socket.socket() as tried:
        try:
            tried.bind((HOST, port or 0))
        except OSError:
            raise InputError(f"--port {port}: another program uses this port; choose another one, or leave the option "
                             "out and a free one is taken") from None  # fmt: skip
        return int(tried.getsockname()[1])


def run_studio(
    folder: Path, scenario: Path | None, *, port: int | None, opens_browser: bool, catalogs: Sequence[Path] = (),
    say: Callable[[str], None],
) -> None:  # fmt: skip
    """Serve the studio of a folder until Ctrl-C.

    Parameters
    ----------
    scenario : Path or None
        Opened first; else the first one of the folder.
    port : int or None
        On the loopback interface; a free one where none is given.
    opens_browser : bool
        Whether the default browser opens the page.
    say : callable
        Shows the address.

    Raises
    ------
    InputError
        Where the extra is not installed, the port is in use, or another studio works on the folder.
    """
    refuse_missing_extra()
    used = free_port(port)
    with studio_lock(folder):
        signal.signal(signal.SIGTERM, _as_ctrl_c)
        compute = Compute()
        from torquerig.studio.server.warm_up import warm_up

        compute.begin(warm_up, folder.resolve(), scenario, tuple(catalogs))
        token = secrets.token_urlsafe(24)
        try:
            with suppress(KeyboardInterrupt):  # the way to end it
                _serve(folder, scenario, used, token, compute, opens_browser=opens_browser, catalogs=catalogs, say=say)
        finally:
            compute.close()


def _serve(
    folder: Path, scenario: Path | None, port: int, token: str, compute: Compute, *, opens_browser: bool,
    catalogs: Sequence[Path], say: Callable[[str], None],
) -> None:  # fmt: skip
    from nicegui import app, run, ui

    from torquerig.studio.server.guard import Guard
    from torquerig.studio.server.tabs import Tabs
    from torquerig.studio.steps import STEPS

    tabs = Tabs(folder, scenario, tuple(catalogs), compute)
    app.on_startup(lambda: run.io_bound(_prepare, tabs))
    app.config.quasar_config["loadingBar"]["skipHijack"] = True  # its bar has no name for a screen reader
    _serve_files()
    app.add_middleware(Guard, token=token, port=port)

    @ui.page("/", title=f"torquerig studio: {folder.resolve().name}")
    async def page(step: str = "") -> None:
        await show_page(tabs, STEPS, step)

    address = f"http://{HOST}:{port}/?token={token}"
    app.on_startup(lambda: _say_when_served(address, port, say))
    ui.run(
        host=HOST, port=port, reload=False, show=f"/?token={token}" if opens_browser else False, dark=None,
        tailwind=False, show_welcome_message=False, gzip_middleware_factory=None, favicon="🔧",
        binding_refresh_interval=None, reconnect_timeout=10.0, ws_per_message_deflate=False,
    )  # fmt: skip


async def _say_when_served(address: str, port: int, say: Callable[[str], None]) -> None:
    """Show the address once the port answers; the server calls its startup handlers before it listens."""
    while True:
        with suppress(OSError):
            _, stream = await asyncio.open_connection(HOST, port)
            stream.close()
            return say(address)
        await asyncio.sleep(LISTENS)


def _prepare(tabs: Tabs) -> None:
    """Do what the first page needs while the browser loads it."""
    from torquerig.studio.server.plot import prepare

    tabs.prepare()
    prepare()


def _serve_files() -> None:
    """Serve style sheets and scripts of installed packages, so that the page loads nothing from elsewhere."""
    from nicegui import app

    import torquerig.reporting

    bokeh = find_spec("bokeh")
    assert bokeh is not None
    assert bokeh.submodule_search_locations is not None
    reporting = Path(torquerig.reporting.__path__[0])
    app.add_static_files("/studio/bokeh", Path(bokeh.submodule_search_locations[0]) / "server" / "static" / "js")
    app.add_static_files("/studio/report", reporting / "templates")
    app.add_static_files("/studio/page", Path(__file__).parent / "page")


async def show_page(tabs: Tabs, steps: Sequence[Step], step: str) -> None:
    """Draw the page of the tab that asks for it."""
    from nicegui import ui

    from torquerig.studio.server.elements import words
    from torquerig.studio.server.frame import Frame

    ui.add_head_html(HEAD)
    client = ui.context.client
    waiting = words("The studio starts.", kind="status")
    try:
        await client.connected(timeout=CONNECTED)
    except TimeoutError:  # what loaded the page runs no scripts
        return
    tab = tabs.tab(client.tab_id or "")
    waiting.delete()
    Frame(tab, steps, first=step)
