"""Checks of the numbers of a machine or control against the bounds of their fields."""

from __future__ import annotations

from typing import Any, get_type_hints

from torquerig.parameter import Parameter


def check_fields(made: Any) -> None:
    """Raise ValueError, one sentence with class, field and bound, where a declared number is out of range."""
    for name, hint in get_type_hints(type(made), include_extras=True).items():
        for declared in getattr(hint, "__metadata__", ()):
            if isinstance(declared, Parameter):
                _check(made, name, declared)


def _check(made: Any, name: str, declared: Parameter) -> None:
    held = getattr(made, name)
    for number in held if isinstance(held, tuple) else (held,):
        try:
            declared.checked(float(number))
        except ValueError as error:
            raise ValueError(f"{type(made).__name__}.{name}: {error}") from None
