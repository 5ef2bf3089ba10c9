"""Words that name the lines of a decision sheet, in English and German; a whole name must match, not a part of it."""

from __future__ import annotations

import re
from enum import StrEnum
from functools import lru_cache


class Total(StrEnum):
    """What a line of results states."""

    SUM = "sum"
    PLAIN = "unweighted sum"
    WEIGHTED = "weighted sum"
    BETTER = "count of +"
    WORSE = "count of -"
    SAME = "count of S"
    MEAN = "mean"
    SHARE = "share of the ideal"
    RANK = "rank"


class Word(StrEnum):
    """What a single line or corner is."""

    CRITERION = "criterion"
    ALTERNATIVE = "alternative"
    WEIGHT = "weight"
    MASS_OR_WEIGHT = "weight or mass"
    LETTER = "letter of weights"
    DATUM = "datum"
    IDEAL = "ideal"
    UNIT = "unit"
    NUMBER = "number of the line"


_SUM = r"(sums?|totals?|summen?|gesamt|gesamtsumme|gesamtergebnis|score|overall|ergebnis|result|net|netto)"
_OF = r"( score| sum| total| summe| rating| value| points?| punkte?| result| wert)?"
_COUNT = r"(sum|total|number|count|no|anzahl|summe|zahl|σ|∑)( of| der)?"
_TOTALS: dict[Total, tuple[str, ...]] = {
    Total.RANK: (r"ranks?", "ranking", "rang", "rangfolge", "platz", "platzierung", "order", r"rank by .*"),
    Total.BETTER: (rf"({_COUNT} ?)?(\+|plus|pluses|positives?|better)('?s| signs?)?",),
    Total.WORSE: (rf"({_COUNT} ?)?(-|minus|minuses|negatives?|worse)('?s| signs?)?",),
    Total.SAME: (rf"{_COUNT} ?(s|0|=|sames?|zeros?|null|nullen|equal|gleich)('?s)?", "sames?"),
    Total.MEAN: (
        r"(weighted |gewichteter? )?(average|mean|avg|mittelwert|mittel|durchschnitt|ø)( score| rating| value)?",
    ),
    Total.SHARE: (
        r"t ?/ ?t[_ ]?max", r"share( of (the )?ideal)?", "(technische )?wertigkeit", "% of ideal",
        r"relativer? (wert|value|score)", r"normali[sz]ed (score|total|sum)",
    ),
    Total.PLAIN: (rf"(unweighted|plain|ungewichtete?|raw|roh)[ -]?({_SUM}{_OF}|punkte|points|summe)",),
    Total.WEIGHTED: (
        rf"(weighted|gewichtete?r?|gew\.?)[ -]?({_SUM}{_OF}|punkte|points)", rf"{_SUM}( score)? (weighted|gewichtet)",
    ),
    Total.SUM: (
        rf"{_SUM}{_OF}", r"gesamt(punkte|punktzahl|wert|nutzen|nutzwert|note|bewertung|urteil|score)", "punktsumme",
        "nutzwert", "bilanz", "balance", "[σ∑]",
    ),
}  # fmt: skip
_WORDS: dict[Word, tuple[str, ...]] = {
    Word.CRITERION: (
        r"((selection|evaluation|decision) )?criteri(on|a)", r"(bewertungs|auswahl)?kriteri(um|en)", "requirements?",
        "anforderung(en)?",
    ),
    Word.ALTERNATIVE: (
        "alternatives?", "alternativen", "concepts?", "konzepte?", "variants?", "varianten?", "options?", "optionen",
        "solutions?", "lösung(en|svarianten?)?", "designs?", "candidates?", "kandidaten?",
    ),
    Word.WEIGHT: (
        "weights", "weighting", "weight(ing)? factors?", r"(rel\.|relative) (weight|gewicht)",
        r"gew\.?(-?faktor)?", "wgt",
        "(relative )?importance", "gewichtung(sfaktor(en)?)?", "gewichte", "bedeutung", "wichtung", "wichtigkeit",
        "gewichtsfaktor", r"(weight|gewicht|gewichtung|weighting)( in)? ?(%|per ?cent|prozent)",
    ),
    Word.MASS_OR_WEIGHT: ("weight", "gewicht", r"wt\.?"),
    Word.LETTER: (r"[gw]_?i?",),
    Word.DATUM: ("datum", "base ?line", "reference", "referenz", r"ref\.?", "bezug", "referenz(lösung|konzept)"),
    Word.IDEAL: ("ideal", "ideale? (solution|lösung|alternative)", "ideallösung", "optimum"),
    Word.UNIT: ("units?", "einheit(en)?"),
    Word.NUMBER: (r"no\.?", r"nr\.?", "#", r"pos\.?", "id", r"lfd\.? ?nr\.?", "item"),
}  # fmt: skip
_BRACKETS = re.compile(r"\s*[\[(]([^\])]*)[\])]\s*$")
_NUMBERED = re.compile(
    r"(alternative|concept|konzept|variante?|option|solution|lösung|design|candidate|kandidat) ?\S{1,3}"
)


def plain_name(text: str) -> str:
    """Return a name in small letters, without unit in brackets and colon."""
    text = text.casefold().strip().translate(str.maketrans("\u2212\u2013\u2014\u2019\u2018", "---''"))
    return " ".join(text.rstrip(" :").split())


def unit_in_name(text: str) -> str:
    """Return the text in the brackets at the end of a name, empty where there is none."""
    found = _BRACKETS.search(text)
    return found.group(1).strip() if found else ""


@lru_cache(maxsize=4096)
def total_of(text: str) -> Total | None:
    """Return which result a line of this name states, or None for the name of something else."""
    name = re.sub(r"( in)? ?%$", "", plain_name(_BRACKETS.sub("", text) or text))
    return next((kind for kind, patterns in _TOTALS.items() if any(re.fullmatch(one, name) for one in patterns)), None)


@lru_cache(maxsize=4096)
def word_of(text: str) -> Word | None:
    """Return what a line of this name is, or None; ``weight [kg]`` is a criterion, ``weight [%]`` is a weight."""
    unit = unit_in_name(text)
    name = plain_name(_BRACKETS.sub("", text) or text)
    found = next((word for word, patterns in _WORDS.items() if any(re.fullmatch(one, name) for one in patterns)), None)
    if found is Word.MASS_OR_WEIGHT and unit:
        return Word.WEIGHT if unit in ("%", "1", "-", "in %") else None
    return found


@lru_cache(maxsize=4096)
def is_datum(text: str) -> bool:
    """Return whether a name states the datum, also as an addition such as ``belt drive (datum)``."""
    parts = [text, *re.findall(r"[\[(]([^\])]*)[\])]", text), *re.split(r"[:,/]| - ", text)]
    return any(part and word_of(part) is Word.DATUM for part in parts)


def is_numbered_alternative(text: str) -> bool:
    """Return whether a name is of the kind ``concept A`` or ``Variante 2``."""
    return re.fullmatch(_NUMBERED, plain_name(text)) is not None


def names_product(text: str) -> bool:
    """Return whether a name is of the kind ``weighted``, ``g x p`` or ``Produkt``."""
    return re.search(r"weighted|gewichtet|product|produkt|\b[gwp] ?[x×*·] ?[gwp]\b", plain_name(text)) is not None
