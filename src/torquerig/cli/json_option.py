"""The option ``--json OUT`` of a command: the result of its function, written whole or not at all."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, replace
from functools import wraps
from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from torquerig.cli.common_options import FROM_CACHE
from torquerig.cli.output_paths import check_output_paths
from torquerig.errors import TorquerigError
from torquerig.reporting.json_results.values import Missing

if TYPE_CHECKING:
    from torquerig.reporting.json_results.provenance import Provenance

STANDARD_OUTPUT = "-"
_OF_TIME_ALONE = ("workers", "cluster", "cache", "no_cache")
_WANTED: ContextVar[bool] = ContextVar("wants_json", default=False)


@dataclass(frozen=True)
class Partly:
    """A result that is written although a part of the work failed; the error is raised afterwards."""

    result: Any
    error: TorquerigError


def json_option(
    command: str, *, reads: Sequence[str] = (), bare: str = ""
) -> Callable[[Callable[..., Any]], Callable[..., None]]:
    """Return a decorator that adds ``--json OUT`` to the function of a command and writes what it returns.

    Parameters
    ----------
    command : str
        Name in the schema: ``torquerig.COMMAND/1``.
    reads : sequence of str
        Parameters of the function that are input files or folders: none is overwritten, each file is hashed.
    bare : str
        Parameter with the files of a command in which ``--json`` without a value writes to standard output: an input
        that follows the option is an input, not OUT. Empty where OUT is required.
    """
    form: dict[str, Any] = {"is_flag": False, "flag_value": STANDARD_OUTPUT} if bare else {}

    def decorated(function: Callable[..., Any]) -> Callable[..., None]:
        @click.option(
            "--json", "json_out", default=None, metavar="OUT", help="JSON file to write; - writes to standard output.",
            **form,
        )  # fmt: skip
        @wraps(function)
        def run(*args: Any, json_out: str | None, **kwargs: Any) -> None:
            if bare and json_out is not None and _is_input(json_out):
                kwargs[bare], json_out = (Path(json_out), *kwargs[bare]), STANDARD_OUTPUT
            if json_out is None:
                _done(function(*args, **kwargs))
                return
            from torquerig.reporting.json_results.document import json_text

            if json_out != STANDARD_OUTPUT:
                _check(Path(json_out), command, kwargs, reads)
            call = JsonCall(command, tuple(reads), function, click.get_current_context())
            with silent_output(json_out == STANDARD_OUTPUT):
                made, document = call.done(*args, **kwargs)
            write_json(json_text(document), json_out)
            _done(made)

        run.json_form = (command, tuple(reads), function)  # type: ignore[attr-defined] # for commands that call others
        return run

    return decorated


@dataclass(frozen=True)
class JsonCall:
    """A call of a command whose result becomes a JSON document."""

    command: str
    reads: tuple[str, ...]
    function: Callable[..., Any]
    context: click.Context

    @classmethod
    def of(cls, context: click.Context) -> JsonCall:
        """Return the call of a context whose options are read."""
        command, reads, function = getattr(context.command.callback, "json_form")  # noqa: B009 (set by json_option)
        return cls(command, reads, function, context)

    def done(self, *args: Any, **kwargs: Any) -> tuple[Any, dict[str, Any]]:
        """Run the command; return what its function returns, and the document."""
        from torquerig.reporting.json_results.document import json_document

        origin = self.origin(kwargs)  # before the run, which may write among its inputs
        with _for_json():
            made = self.function(*args, **kwargs)
        result = made.result if isinstance(made, Partly) else made
        stated = getattr(result, "seed", None)
        if isinstance(stated, int) and isinstance(origin.seed, Missing):
            origin = replace(origin, seed=stated)
        if FROM_CACHE in self.context.meta:
            origin = replace(origin, from_cache=self.context.meta[FROM_CACHE])
        name = getattr(result, "json_name", self.command)  # --all-points of compare has a result of another form
        return made, json_document(name, result, origin)

    def origin(self, kwargs: dict[str, Any]) -> Provenance:
        """Return version, hashes, options, and the seed where an option states it."""
        from torquerig.reporting.json_results.provenance import provenance_of

        return provenance_of(
            list(_inputs(kwargs, self.reads)), seed=kwargs.get("seed"), catalogs=_catalogs(kwargs),
            options=stated_options(self.context, without=(*self.reads, "json_out")),
        )  # fmt: skip


def stated_options(context: click.Context, *, without: Sequence[str]) -> dict[str, Any]:
    """Return the options and arguments that the command line states, by their names; of a path its name alone.

    Options that change the time alone are left out: the result does not depend on them.
    """
    found = {}
    for one in context.command.params:
        name = str(one.name)
        stated = context.get_parameter_source(name) is click.core.ParameterSource.COMMANDLINE
        if not stated or name in (*without, *_OF_TIME_ALONE):
            continue
        spoken = one.opts[-1].lstrip("-") if isinstance(one, click.Option) else name
        found[spoken] = _plain_option(context.params[name])
    return found


def _plain_option(value: Any) -> Any:
    if isinstance(value, tuple | list):
        return [_plain_option(one) for one in value]
    return value.name if isinstance(value, Path) else value


def wants_json() -> bool:
    """Return whether the running command has ``--json``, for one that computes more or less for it."""
    return _WANTED.get()


@contextmanager
def _for_json() -> Iterator[None]:
    token = _WANTED.set(True)
    try:
        yield
    finally:
        _WANTED.reset(token)


def write_json(text: str, out: str) -> None:
    """Write the text to standard output, or to a file that is complete or not changed."""
    if out == STANDARD_OUTPUT:
        click.echo(text, nl=False)
        return
    from torquerig.whole_file import whole_file

    with whole_file(Path(out)) as partial:
        partial.write_text(text, encoding="utf-8", newline="\n")
    click.echo(f"wrote {out}")


@contextmanager
def silent_output(silent: bool) -> Iterator[None]:
    """Keep standard output empty meanwhile if ``silent``."""
    before = sys.stdout
    try:
        sys.stdout = StringIO() if silent else before
        yield
    finally:
        sys.stdout = before


def _is_input(out: str) -> bool:
    return out != STANDARD_OUTPUT and Path(out).suffix.lower() != ".json" and Path(out).exists()


def _done(made: Any) -> None:
    if isinstance(made, Partly):
        raise made.error


def _inputs(kwargs: dict[str, Any], reads: Sequence[str]) -> Iterator[Path]:
    """Yield the input files of a call: a recording with its sidecar, of a folder the files in it."""
    from torquerig.recordings.files.sidecar import sidecar_path

    for path in _paths(kwargs[name] for name in reads):
        files = sorted(one for one in path.rglob("*") if one.is_file()) if path.is_dir() else [path]
        for file in files:
            yield file
            if file.suffix.lower() != ".yaml":
                yield sidecar_path(file)


def _catalogs(kwargs: dict[str, Any]) -> list[Path]:
    """Return the catalog folders that a call reads; none where the command reads no catalog."""
    if "catalogs" not in kwargs:
        return []
    from torquerig.catalog.search import catalog_folders

    return catalog_folders(kwargs.get("scenario"), kwargs["catalogs"])


def _paths(values: Any) -> Iterator[Path]:
    for value in values:
        if isinstance(value, Path):
            yield value
        elif isinstance(value, str) and Path(value).is_file():  # a name or a file, as of synth fault
            yield Path(value)
        elif isinstance(value, tuple | list):
            yield from _paths(value)


def _check(out: Path, command: str, kwargs: dict[str, Any], reads: Sequence[str]) -> None:
    """Refuse to write over an input, over another output of the call, or over a file of another kind."""
    others = [value for name, value in kwargs.items() if name not in reads]
    if out.resolve() in {path.resolve() for path in _paths(others)}:
        raise click.UsageError(f"{out}: two outputs have this path; name two files")
    mark = f'"schema": "torquerig.{command}'
    check_output_paths(
        [(out, mark)], inputs=_inputs(kwargs, reads), what=f"JSON of torquerig {command.replace('-', ' ')}"
    )
