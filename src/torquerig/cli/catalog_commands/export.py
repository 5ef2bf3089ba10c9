"""``torquerig catalog export``: the gear fields of OPC UA Powertrain of a gearbox."""

from __future__ import annotations

from pathlib import Path

import click

from torquerig.catalog.entry import estimates
from torquerig.catalog.exchange.gear_attributes import FIELDS, node_set
from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import catalog_option
from torquerig.cli.completions import gearbox_names
from torquerig.cli.json_option import json_option
from torquerig.errors import InputError
from torquerig.reporting.json_results.simulate import WrittenResult, named
from torquerig.whole_file import whole_file


@click.command("export")
@click.argument("name", shell_complete=gearbox_names)
@click.argument("file", type=click.Path(path_type=Path))
@catalog_option
@json_option("catalog-export")
@click.pass_context
def command(context: click.Context, *, name: str, file: Path, catalogs: tuple[Path, ...]) -> WrittenResult:
    """Write the documented values of the gearbox NAME as PtGearAttributes of OPC UA Powertrain (a node set).

    A value that is an interval has no field there and is left out; the command lists what it left out. A sizing is
    written with torquerig size SCENARIO --shell FILE.

    Example: torquerig catalog export reference-5-1 gear.xml
    """
    box = catalog_for(None, (*(context.obj or ()), *catalogs)).gearbox(name)
    if file.suffix != ".xml":
        raise InputError(f"{file}: a node set ends in .xml; write {file.with_suffix('.xml')}")
    if file.exists() or file.is_symlink():
        raise InputError(f"{file}: is there already; choose another name")
    known = dict(estimates(box))
    wanted = [field for field, _, _ in FIELDS.values() if field != "ratio"]
    values = {"ratio": box.ratio}
    values |= {field: known[field].nominal() for field in wanted if known[field].documented and not known[field].rel_sd}
    left = [field for field in wanted if field not in values]
    with whole_file(file) as partial:
        partial.write_bytes(node_set(box.name, values))
    click.echo(
        f"{file}: written, with {', '.join(values)}"
        + (f"; left out, not one number: {', '.join(left)}" if left else "")
    )
    return WrittenResult(named([file]), tuple(f"left out, not one number: {one}" for one in left))
