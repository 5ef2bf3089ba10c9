"""What the shell completes after an option: names of catalog entries, filter chains, faults and schemas."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

import click
from click.shell_completion import CompletionItem

Complete = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]


def names_from(names: Callable[[], Iterable[str]]) -> Complete:
    """Return a completion from a list of names, which is made when the shell wants it."""

    def complete(_: click.Context, __: click.Parameter, incomplete: str) -> list[CompletionItem]:
        return [CompletionItem(name) for name in sorted(set(names())) if name.startswith(incomplete)]

    return complete


def _entries(*shelves: str) -> Iterable[str]:
    """Yield the names of catalog entries: those of their files, which no catalog has to be read for."""
    from torquerig.catalog.shipped import shipped_folder

    for folder in (shipped_folder(), Path("catalogs")):
        for shelf in shelves:
            yield from (path.stem for path in (folder / shelf).glob("*.yaml"))


def _chains() -> Iterable[str]:
    import yaml

    from torquerig.catalog.shipped import shipped_scenarios

    return [str(name) for name in yaml.safe_load((shipped_scenarios() / "filters.yaml").read_bytes())["filters"]]


def _faults() -> Iterable[str]:
    from torquerig.synthetic.faults.registry import BY_NAME

    return BY_NAME


def _schemas() -> Iterable[str]:
    from torquerig.reporting.file_schemas.named import FILES, OUTPUTS

    return (*FILES, *OUTPUTS)


motor_names = names_from(lambda: _entries("motors"))
gearbox_names = names_from(lambda: _entries("gearboxes"))
entry_names = names_from(lambda: _entries("motors", "gearboxes", "sensors", "couplings", "classes"))
chain_names = names_from(_chains)
fault_names = names_from(_faults)
schema_names = names_from(_schemas)
