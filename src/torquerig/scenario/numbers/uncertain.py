"""Numbers of a scenario that are not exactly known: ``{value, rel_sd}``, ``{low, high}`` or ``5 N*m ± 10 %``."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from types import UnionType
from typing import Annotated, Any, TypeVar, Union, get_args, get_origin, get_type_hints

from pydantic import BaseModel

from torquerig.errors import InputError, UnitError, did_you_mean
from torquerig.parameter import Estimate, Parameter
from torquerig.scenario.numbers.percent import Percent, read_percent
from torquerig.scenario.numbers.tolerance import NumberText, Uncertain, UncertaintyError, deviation, uncertain_number

Known = TypeVar("Known")
Place = Callable[[tuple[Any, ...]], str]
KEYS = ("value", "rel_sd", "low", "high")
_PERCENT = NumberText(unit="%", read=read_percent, write=float)
_BARE = NumberText.bare()


@dataclass(frozen=True, kw_only=True)
class Resolved:
    """Data of a scenario in which every number is one value, and what is known of the uncertain ones.

    Parameters
    ----------
    values
        As the file states it; an uncertain number is replaced by its value, or by a random one of its interval.
    uncertain : mapping of str to Uncertain
        By dotted path within the data: ``mean_by_occupancy_percent.5``.
    """

    values: Any
    uncertain: Mapping[str, Uncertain] = field(default_factory=dict)

    @staticmethod
    def named(owner: str, by_path: Mapping[str, Known]) -> dict[str, Known]:
        """Return what is known by path with the name of the part or section before each path."""
        return {f"{owner}.{path}": known for path, known in by_path.items()}

    @property
    def estimates(self) -> dict[str, Estimate]:
        """What is known of each number that is not exact, by path."""
        return {path: one.known for path, one in self.uncertain.items() if deviation(one.known) > 0}

    @property
    def assumed(self) -> dict[str, str]:
        """What was drawn from which interval, by path."""
        return {path: one.assumed for path, one in self.uncertain.items() if one.assumed}

    @property
    def kept(self) -> dict[str, str]:
        """Stated values with their uncertainty, by path."""
        return {path: one.kept for path, one in self.uncertain.items() if one.kept}


def resolved(
    written: Any, model: type[Any], *, owner: str, seed: int, place: Place, in_a_line: bool = False
) -> Resolved:  # fmt: skip
    """Return the data of a part or section with one value for every number.

    Parameters
    ----------
    written
        The mapping as the file states it.
    model : type
        The class of the part, or the model of the section; its annotations say which values are numbers.
    owner : str
        Dotted name before the paths; it and ``seed`` determine what is drawn from an interval.
    place : callable
        File, line and key of a path in the data.
    in_a_line : bool
        Whether N stands for N*m.

    Raises
    ------
    InputError
        With place and remedy, for an uncertainty that cannot be used.
    """
    found: dict[str, Uncertain] = {}

    def number(value: Any, text: NumberText, path: tuple[Any, ...]) -> Any:
        dotted = ".".join(f"{key:g}" if isinstance(key, float) else str(key) for key in path)
        try:
            made = uncertain_number(value, text, name=f"{owner}.{dotted}", seed=seed)
        except UncertaintyError as error:
            raise InputError(f"{place((*path, error.key))}: {error}") from None
        except (UnitError, ValueError) as error:
            raise InputError(f"{place(path)}: {error}") from None
        if made is None:
            return value
        found[dotted] = made
        return made.written

    def walked(value: Any, hint: Any, path: tuple[Any, ...]) -> Any:
        text = _number_of(hint, in_a_line)
        if text is not None:
            _refuse_unknown(value, path, place)
            return number(value, text, path)
        if _is_count(hint):
            _refuse_uncertain_count(value, path, place)
            return value
        parts = dict(_inner(value, hint))
        if not parts:
            return value
        changed = {key: walked(value[key], inner, (*path, key)) for key, inner in parts.items()}
        return [*changed.values()] if isinstance(value, list) else {**value, **changed}

    values = walked(written, model, ())
    return Resolved(values=values, uncertain=found)


def _refuse_unknown(value: Any, path: tuple[Any, ...], place: Place) -> None:
    for key in value if isinstance(value, Mapping) else ():
        if key not in KEYS:
            raise InputError(f"{place((*path, key))}: unknown key; {did_you_mean(str(key), KEYS)}")


def _refuse_uncertain_count(value: Any, path: tuple[Any, ...], place: Place) -> None:
    if isinstance(value, Mapping) and set(value) & {*KEYS}:
        raise InputError(f"{place(path)}: a count is a whole number without uncertainty; write it alone, such as 4")


def _number_of(hint: Any, in_a_line: bool) -> NumberText | None:
    """Return how a number of this annotation is read; None where it is no number with decimals."""
    hint = _stated_option(hint)
    if hint is float:
        return _BARE
    if hint == Percent:
        return _PERCENT
    notes = getattr(hint, "__metadata__", ())
    parameter = next((note for note in notes if isinstance(note, Parameter)), None)
    if parameter is None:
        return _BARE if notes and get_args(hint)[0] is float else None
    return NumberText.of(parameter.in_a_line if in_a_line else parameter)


def _is_count(hint: Any) -> bool:
    return _stated_option(hint) is int


def _stated_option(hint: Any) -> Any:
    """Return what may be written of ``X | None``."""
    options = [one for one in get_args(hint) if one is not type(None)]
    return options[0] if get_origin(hint) in (Union, UnionType) and len(options) == 1 else hint


def _inner(value: Any, hint: Any) -> Iterator[tuple[Any, Any]]:
    """Yield (key, annotation) of every entry of a mapping or list that may be or hold a number."""
    hint = _stated_option(hint)
    if get_origin(hint) is Annotated:
        hint = get_args(hint)[0]
    arguments = get_args(hint)
    if isinstance(value, Mapping) and isinstance(hint, type) and get_origin(hint) is None:
        if issubclass(hint, BaseModel) or getattr(hint, "__pydantic_config__", None) is not None:
            hints = _hints(hint)
            yield from ((key, hints[key]) for key in value if key in hints)
    elif isinstance(value, Mapping) and len(arguments) == 2:
        yield from ((key, arguments[1]) for key in value)
    elif isinstance(value, list) and arguments:
        each = arguments if Ellipsis not in arguments else arguments[:1] * len(value)
        if len(each) == len(value):
            yield from enumerate(each)


@cache
def _hints(model: Any) -> dict[str, Any]:
    return get_type_hints(model, include_extras=True)
