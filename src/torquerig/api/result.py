"""What the results of all functions have: a sentence, a table, JSON, a picture, and a form for notebooks."""

from __future__ import annotations

import json
from abc import ABC, abstractmethod
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any

from torquerig.shown import notebook_html
from torquerig.whole_file import whole_file

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure


class Result(ABC):
    """A frozen result that can be shown, drawn and written."""

    @abstractmethod
    def summary(self) -> str:
        """Return the answer in one or two sentences."""

    @abstractmethod
    def to_frame(self) -> pd.DataFrame:
        """Return the result as a table; its units are in the names of the columns or in a column ``unit``."""

    @abstractmethod
    def plot(self) -> Figure:
        """Return the picture of the result; a notebook shows it."""

    def as_dict(self) -> dict[str, Any]:
        """Return the result as plain values: the summary, and the rows of the table."""
        return {"summary": self.summary(), "rows": records(self.to_frame())}

    def to_json(self, path: str | Path | None = None) -> str:
        """Return the result as JSON, and write it to ``path`` where one is given; unknown numbers are null."""
        text = json.dumps(plain(self.as_dict()), indent=2, ensure_ascii=False, allow_nan=False) + "\n"
        if path is not None:
            with whole_file(Path(path)) as partial:
                partial.write_text(text, encoding="utf-8", newline="\n")
        return text

    def _repr_html_(self) -> str:
        """Return what a notebook shows: the summary and the first rows of the table."""
        return notebook_html(self.summary(), self.to_frame())


def records(frame: pd.DataFrame) -> list[dict[str, Any]]:
    """Return the rows of a table as plain mappings."""
    return [{str(key): value for key, value in row.items()} for row in frame.reset_index(drop=True).to_dict("records")]


def plain(value: Any) -> Any:
    """Return a value as JSON can hold it: numpy numbers as Python's, what is no number as None."""
    if isinstance(value, dict):
        return {str(key): plain(one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [plain(one) for one in value]
    if hasattr(value, "item") and not isinstance(value, str):
        value = value.item()
    return None if isinstance(value, float) and not isfinite(value) else value
