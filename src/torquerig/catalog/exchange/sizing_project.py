"""What a submodel of IDTA 02021-1-0 (Sizing of Power Drive Trains) says of a drive, in the words of this program.

The template has requirements (motion, load, surroundings) and results (components and their use). It has no data of
components such as inertia or torque constant; its use case 6 leaves them to later versions. Source: IDTA 02021-1-0,
tables of chapter 2 and the concept descriptions of its template 1-0-2 (units).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite
from pathlib import PurePosixPath

from torquerig.catalog.exchange.motion_file import Motion, joined, read_motion
from torquerig.catalog.exchange.shell_tree import Element, ShellFile
from torquerig.errors import InputError

MEANING = "admin-shell.io/idta/PowerDriveTrainSizing/1/0"
SECTION_UNITS = {"FrictionTorque": "N*m", "LoadTorque": "N*m", "MomentOfInertiaOfLoad": "kg*m^2"}
OF_MOTION = ("FrictionTorque", "LoadTorque")


@dataclass(frozen=True)
class SizingProject:
    """The requirements and components of one submodel.

    Parameters
    ----------
    name, tool : str
        Of the sizing project, and of the program that sized it.
    motion : Motion or None
        All rotative sections one after the other.
    inertias : tuple of float
        Moment of inertia of the load, one value a section that states it [kg m^2].
    ambient : tuple of float or None
        Lowest and highest ambient temperature of the motor [C].
    mechanism : mapping of str to mapping
        The transformation mechanism with its values as they are written.
    components : tuple of mapping
        Type, maker, article number and order code of each main component.
    unused : tuple of str
        Values that are stated and not taken over, with their paths.
    """

    name: str
    tool: str
    motion: Motion | None
    inertias: tuple[float, ...]
    ambient: tuple[float, float] | None
    mechanism: Mapping[str, Mapping[str, str]]
    components: tuple[Mapping[str, str], ...]
    unused: tuple[str, ...]


def read_sizing_project(shell: ShellFile, where: str) -> SizingProject:
    """Return the one submodel of IDTA 02021 in ``shell``.

    Raises
    ------
    InputError
        Where there is none or several, a number is none, or a motion file is missing or damaged.
    """
    found = [one for one in shell.submodels if is_sizing(one)]
    if len(found) != 1:
        names = ", ".join(one.id_short or "without name" for one in shell.submodels)
        raise InputError(
            f"{where}: holds {len(found)} submodels PowerDriveTrainSizing (IDTA 02021); one is wanted of {names}"
        )
    submodel, used = found[0], set[int]()
    project = _child(submodel, "SizingProjectInformation")
    requirements = _child(submodel, "ApplicationRequirements")
    sections = _sections(requirements)
    motions = [_motion(one, shell, where, used) for one in sections]
    inertias = [_number(one, "MomentOfInertiaOfLoad", where, used) for one in sections]
    ambient = _ambient(_child(requirements, "Environmental"), where, used)
    mechanism = {one.id_short: _texts(one, used) for one in _child(submodel, "TransformationMechanism").children}
    components = [_component(one, used) for one in _child(submodel, "SizingResult").all_of("MainComponent")]
    name, tool = (_taken(project, key, used) for key in ("SizingProjectName", "SizingToolName"))
    return SizingProject(
        name=name, tool=tool, motion=joined([one for one in motions if one is not None]),
        inertias=tuple(one for one in inertias if one is not None), ambient=ambient,
        mechanism={key: values for key, values in mechanism.items() if values}, components=tuple(components),
        unused=tuple(_unused(submodel, "", used)),
    )  # fmt: skip


def is_sizing(submodel: Element) -> bool:
    """Return whether a submodel is one of IDTA 02021: by its semantic id, else by its name."""
    return any(one.endswith(MEANING) for one in submodel.meaning) or submodel.id_short == "PowerDriveTrainSizing"


EMPTY = Element("", "")


def _child(element: Element, id_short: str) -> Element:
    return element.child(id_short) or EMPTY


def _sections(requirements: Element) -> list[Element]:
    patterns = [one.child("MotionPatternSections") for one in requirements.all_of("MotionPattern")]
    return [section for one in patterns if one is not None for section in one.all_of("RotativeSection")]


def _motion(section: Element, shell: ShellFile, where: str, used: set[int]) -> Motion | None:
    file = section.child("MotionSectionFile")
    constants = {key: _number(section, key, where, used) for key in OF_MOTION}
    if file is None or not file.value.strip():
        return None
    used.add(id(file))
    name = "/" + str(PurePosixPath(file.value.strip().removeprefix("file:"))).lstrip("/")
    if name not in shell.parts:
        raise InputError(
            f"{where}: the motion file {file.value!r} is not in the package; export it as .aasx with its files"
        )
    metadata = section.child("MetadataRotativeMotionFile")
    used.update(id(one) for one in (metadata.children if metadata else ()))
    return read_motion(
        shell.parts[name], f"{where}: {name}", {key: one for key, one in constants.items() if one is not None}
    )


def _number(element: Element, id_short: str, where: str, used: set[int]) -> float | None:
    text = _taken(element, id_short, used)
    if not text:
        return None
    try:
        number = float(text)
    except ValueError:
        number = float("nan")
    if not isfinite(number):
        raise InputError(f"{where}: {id_short} is {text!r}, no number; correct it in the program that wrote the file")
    return number


def _taken(element: Element, id_short: str, used: set[int]) -> str:
    found = element.child(id_short)
    if found is None:
        return ""
    used.add(id(found))
    return found.value.strip()


def _ambient(environment: Element, where: str, used: set[int]) -> tuple[float, float] | None:
    found = environment.child("AmbientTemperatureMotor")
    if found is None or not (found.low and found.high):
        return None
    used.add(id(found))
    ends = [_number(Element("", "", children=(Element("AmbientTemperatureMotor", "property", value=end),)),
                    "AmbientTemperatureMotor", where, set()) for end in (found.low, found.high)]  # fmt: skip
    if None in ends or ends[0] > ends[1]:  # type: ignore[operator]
        raise InputError(f"{where}: AmbientTemperatureMotor is {found.low}..{found.high}; the lower end comes first")
    return ends[0], ends[1]  # type: ignore[return-value]


def _texts(element: Element, used: set[int]) -> dict[str, str]:
    held = [one for one in element.children if one.value.strip()]
    used.update(id(one) for one in held)
    return {one.id_short: one.value.strip() for one in held}


def _component(element: Element, used: set[int]) -> dict[str, str]:
    keys = ("MainComponentType", "ManufacturerName", "ManufacturerArticleNumber", "ManufacturerOrderCode",
            "ManufacturerProductDesignation")  # fmt: skip
    return {key: text for key in keys if (text := _taken(element, key, used))}


def _unused(element: Element, path: str, used: set[int]) -> Iterator[str]:
    for one in element.children:
        here = f"{path}{one.id_short}"
        value = one.value.strip() or f"{one.low}..{one.high}".strip(".")
        if value and id(one) not in used:
            yield f"{here} = {value}"
        yield from _unused(one, f"{here}/", used)


def unused_text(unused: Sequence[str]) -> str:
    """Return the values that were not taken over, one a line, as comments."""
    plain = ("".join(sign if sign.isprintable() else " " for sign in one)[:200] for one in unused)
    return "".join(f"#   {one}\n" for one in plain)
