"""``torquerig studio``: a local page for what-if questions on the files of a folder."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.cli.common_options import catalog_option
from torquerig.studio.server.start import run_studio
from torquerig.studio.session.folder_files import opened_at


@click.command("studio")
@click.argument("where", type=click.Path(path_type=Path), default=Path(), metavar="[FOLDER | SCENARIO]")
@click.option(
    "--port", type=click.IntRange(1024, 65535), default=None, help="Port on this computer. Default: a free one."
)
@click.option("--no-browser", is_flag=True, help="Print the address, and do not open a browser.")
@catalog_option
def command(*, where: Path, port: int | None, no_browser: bool, catalogs: tuple[Path, ...]) -> None:
    """Open a page on this computer that works on the files of FOLDER, by default the current one.

    The page changes motor, gearbox, speed, load and filter and shows what the sensor would record. It saves the same
    files that the other commands read. Only this computer can open it, with the token in its address. Ctrl-C ends it.

    Example: torquerig studio scenarios/wear_rig.yaml
    """
    folder, scenario = opened_at(where)
    if scenario is None and folder != where:
        click.echo(f"{where} has no scenario, so the studio works in {folder}", err=True)
    run_studio(
        folder, scenario, port=port, opens_browser=not no_browser, catalogs=catalogs,
        say=lambda address: click.echo(f"torquerig studio: {address}\nCtrl-C ends it."),
    )  # fmt: skip
