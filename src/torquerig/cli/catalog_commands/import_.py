"""``torquerig catalog import``: a drive of IDTA 02021, or a gear of OPC UA Powertrain, as files of this program."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

import click

from torquerig.catalog.checking.draft import draft
from torquerig.catalog.exchange.gear_attributes import GearAttributes, is_node_set, read_gear
from torquerig.catalog.exchange.shell_tree import read_shell
from torquerig.catalog.exchange.sizing_project import SizingProject, read_sizing_project, unused_text
from torquerig.catalog.exchange.untrusted import read_bytes, xml_of
from torquerig.catalog.search import catalog_for
from torquerig.cli.common_options import catalog_option
from torquerig.cli.json_option import json_option
from torquerig.errors import InputError
from torquerig.reporting.json_results.simulate import WrittenResult, named
from torquerig.schema_comment import schema_comment
from torquerig.units import written_quantity
from torquerig.whole_file import whole_files


@click.command("import")
@click.argument("file", type=click.Path(path_type=Path))
@click.argument("target", type=click.Path(path_type=Path))
@click.option("--like", default="", metavar="CLASS", help="The class that fills what the file does not state.")
@catalog_option
@json_option("catalog-import", reads=("file",))
@click.pass_context
def command(
    context: click.Context, *, file: Path, target: Path, like: str, catalogs: tuple[Path, ...]
) -> WrittenResult:
    """Read FILE of another program and write TARGET; an existing file is never overwritten.

    A sizing project of IDTA 02021 (.aasx, .json or .xml) becomes a folder with profile.csv for duty, size and simulate,
    and requirements.yaml with all else. A gear of OPC UA Powertrain (a node set, .xml) becomes a gearbox entry.

    Example: torquerig catalog import gear.xml catalogs/gearboxes/mine.yaml
    """
    content = read_bytes(file)
    root = xml_of(content, str(file)) if content.lstrip(b"\xef\xbb\xbf \t\r\n")[:1] == b"<" else None
    if root is not None and is_node_set(root):
        classes = catalog_for(None, (*(context.obj or ()), *catalogs)).classes
        gear = read_gear(root, str(file))
        text = _with_values(draft("gearbox", target.stem, classes, like=like), gear, file.name)
        return _write({target: schema_comment(target, "gearbox") + text})
    project = read_sizing_project(read_shell(file), str(file))
    tables = {target / "profile.csv": project.motion.table()} if project.motion else {}
    return _write({target / "requirements.yaml": _requirements(project, file.name), **tables})


def _write(texts: Mapping[Path, str]) -> WrittenResult:
    for path in texts:
        if path.exists() or path.is_symlink():
            raise InputError(f"{path}: is there already; choose another name")
    for path in texts:
        path.parent.mkdir(parents=True, exist_ok=True)
    with whole_files(list(texts)) as partials:
        for partial, text in zip(partials, texts.values(), strict=True):
            partial.write_text(text, encoding="utf-8")
    for path, text in texts.items():
        left = text.count("____")
        click.echo(f"{path}: written" + (", with blanks to fill" if left else ""))
    blanks = [f"{path.name}: {text.count('____')} blanks to fill" for path, text in texts.items() if "____" in text]
    return WrittenResult(named(list(texts)), tuple(blanks))


def _with_values(text: str, gear: GearAttributes, source: str) -> str:
    """Return a draft with the lines of the known fields filled."""
    units = {"backlash": "rad", "stiffness": "N*m/rad", "input_inertia": "kg*m^2", "nominal_torque": "N*m"}
    plain = re.sub(r"[^\w .\-]", "_", source)
    for field, value in gear.values.items():
        if field == "ratio":
            text = re.sub(r"(?m)^ratio: \S+", f"ratio: {value:.9g}", text)
            continue
        shown = written_quantity(float(f"{value:.9g}"), units.get(field, "1"))
        note = f', note: "{gear.notes[field]}"' if gear.notes[field] else ""
        line = f'{field}: {{value: {shown}, evidence: DOC, source: "OPC UA Powertrain, {plain}"{note}}}'
        text = re.sub(rf"(?m)^(# )?{field}: .*$", line, text)
    return text + ("\n# stated in the file and not taken over:\n" + unused_text(gear.unused) if gear.unused else "")


def _requirements(project: SizingProject, source: str) -> str:
    """Return what a sizing project requires, as YAML with comments."""
    lines = [f"# Requirements of {_quoted(source)}, read from IDTA 02021 (Sizing of Power Drive Trains) by torquerig"]
    lines += [f"project: {_quoted(project.name)}", f"sized_with: {_quoted(project.tool)}"]
    if project.motion:
        lines += ["# for a scenario; the speed is that of the load", "operating_point:", "  profile: csv",
                  "  csv: {file: profile.csv}"]  # fmt: skip
    if project.inertias:
        shown = [written_quantity(one, "kg*m^2") for one in project.inertias]
        lines.append(f"load_inertia: [{', '.join(shown)}]  # one a section; the inertia of the part at the output")
    if project.ambient:
        lines.append(
            f"ambient_temperature: [{project.ambient[0]:g}, {project.ambient[1]:g}]  # degrees Celsius, for --ambient"
        )
    for name, values in project.mechanism.items():
        lines += [f"# transformation mechanism {_quoted(name)}, values as written in the file:"]
        lines += [f"#   {_quoted(key)}: {_quoted(value)}" for key, value in values.items()]
    for part in project.components:
        lines.append("# component: " + ", ".join(f"{key} {_quoted(value)}" for key, value in part.items()))
    text = "\n".join(lines) + "\n"
    return text + ("# stated in the file and not taken over:\n" + unused_text(project.unused) if project.unused else "")


def _quoted(text: str) -> str:
    """Return a text of another program as one line of YAML without control characters."""
    plain = "".join(sign if sign.isprintable() else " " for sign in text)[:200]
    return '"' + plain.replace("\\", "\\\\").replace('"', '\\"') + '"'
