"""All figures of all combinations, and the shares of all drives, as CSV text."""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from io import StringIO
from typing import TYPE_CHECKING

from torquerig.harmless import csv_cell
from torquerig.metrics.figure import Figure
from torquerig.reporting.figures.shades import SHARES
from torquerig.reporting.study.tables import decision_words

if TYPE_CHECKING:
    import pandas as pd

    from torquerig.filters.filter_effect import FilterEffect
    from torquerig.study.results import DriveResult, StudyRuns
    from torquerig.study.scoring import Decided

Fields = list[tuple[str, str]]


def combinations_csv(runs: StudyRuns, decided: Decided) -> str:
    """Return one row per motor x gearbox x filter, the ranked ones first; ``?`` is unknown, empty does not apply."""
    order = {name: place for place, name in enumerate(decided.ranked())}
    pairs = [(drive, chain) for drive in runs.drives for chain in runs.study.settings.filters.names]
    pairs.sort(key=lambda pair: order.get(_name(*pair), len(order)))
    said = decision_words(decided)
    rows = [_combination(drive, chain, decided, said) for drive, chain in pairs]
    return csv_text(rows)


def shares_csv(runs: StudyRuns) -> str:
    """Return one row per motor x gearbox: mean, rms of each share, and percent of the fluctuation's power."""
    return csv_text([_shares(drive) for drive in runs.drives])


def table_of(text: str) -> pd.DataFrame:
    """Return one of these CSV texts as a table; what is unknown (``?``) is missing."""
    import pandas as pd

    return pd.read_csv(StringIO(text), na_values="?", keep_default_na=True)


def _name(drive: DriveResult, chain: str) -> str:
    return f"{drive.candidate.name} | {chain}"


def _combination(drive: DriveResult, chain: str, decided: Decided, said: Mapping[str, str]) -> Fields:
    result = drive.chains.get(chain)
    fields = _score(_name(drive, chain), decided)
    fields += _identity(drive)
    fields += [("filter", chain), ("requirements", said[drive.candidate.name]),
               ("out of reach", drive.out_of_reach)]  # fmt: skip
    missing = Figure(unit=drive.disturbance.unit, missing=drive.out_of_reach)
    fields += _figure("reading error", result.truth_error if result else missing)
    by_load = f"reading error by the random load [{drive.disturbance.unit}]"
    fields.append((by_load, _number(result.random_error if result else None)))
    fields += _figure("disturbance", drive.disturbance)
    for name, figure in drive.margins.items():
        fields += _figure(name.replace("_", " "), figure)
    fields += _effect(result.effect if result else None)
    fields.append(("lines left out", "; ".join(result.left_out) if result else ""))
    fields.append(("assumed values", "; ".join(f"{key} = {text}" for key, text in drive.assumed.items())))
    return fields


def _effect(effect: FilterEffect | None) -> Fields:
    values = (
        ("std reduction [%]", effect.std_reduction_percent if effect else None),
        ("variance reduction [%]", effect.variance_reduction_percent if effect else None),
        ("mean change [%]", effect.mean_change_percent if effect else None),
        ("energy change [%]", effect.energy_change_percent if effect else None),
    )
    return [(label, _number(value)) for label, value in values]


def _score(name: str, decided: Decided) -> Fields:
    labels = ("rank", "rank low", "rank high", "T/T_max", "T/T_max low", "T/T_max high")
    result = decided.overall
    if name not in result.alternatives:
        return [(label, "") for label in labels]
    row = result.alternatives.index(name)
    best, worst = result.rank_range
    shares = (result.share[row], result.total_low[row] / result.ideal, result.total_high[row] / result.ideal)
    texts = [*(str(int(rank)) for rank in (result.ranks[row], best[row], worst[row])), *map(_number, shares)]
    return list(zip(labels, texts, strict=True))


def _shares(drive: DriveResult) -> Fields:
    fields = _identity(drive)
    shares, percent = drive.shares, drive.shares.percent() if drive.shares else {}
    unit = drive.disturbance.unit
    fields.append((f"mean [{unit}]", _number(shares.mean if shares else None)))
    fields += [(f"{name} rms [{unit}]", _number(getattr(shares, name) if shares else None)) for name in SHARES]
    fields += [(f"{name} [% of power]", _number(percent.get(name))) for name in SHARES]
    path = drive.load_path
    fields += [
        (f"true load rms [{unit}]", _number(shares.true_load if shares else None)),
        ("J1/(J1+J2)", _number(path.inertia_share if path else None)),
        ("largest gain of the load", _number(path.largest if path else None)),
        ("at [Hz]", _number(path.at if path else None)),
    ]
    return [*fields, ("out of reach", drive.out_of_reach)]


def _identity(drive: DriveResult) -> Fields:
    made = drive.candidate
    whole = made.ratio if made.whole_ratio is None else made.whole_ratio
    return [("motor", made.motor), ("gearbox", made.gearbox), ("ratio", f"{made.ratio:g}"),
            ("whole ratio", f"{whole:g}")]  # fmt: skip


def _figure(name: str, figure: Figure) -> Fields:
    unit = "" if figure.unit == "1" else f" [{figure.unit}]"
    low = figure.value if figure.low is None else figure.low
    high = figure.value if figure.high is None else figure.high
    return [
        (f"{name}{unit}", _number(figure.value)),
        (f"{name} low{unit}", _number(low)),
        (f"{name} high{unit}", _number(high)),
    ]


def _number(value: float | None) -> str:
    return "?" if value is None else f"{value:.6g}"


def csv_text(rows: Sequence[Fields]) -> str:
    """Return rows of (heading, text) as CSV, the headings of the first row on top."""
    buffer = StringIO()
    writer = csv.writer(buffer, lineterminator="\n")
    writer.writerow([csv_cell(label) for label, _ in rows[0]])
    writer.writerows([csv_cell(text) for _, text in row] for row in rows)
    return buffer.getvalue()
