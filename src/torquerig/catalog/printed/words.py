"""The words next to a figure of a data sheet that decide what it means: rms, line-to-line, star, S3 40 %."""

from __future__ import annotations

import re

_TO = r"[\s-]*(?:to|bis)[\s-]*"
_END = r"(?:line|phase|terminal|lead)"
_HALF = rf"(?:zero|0){_TO}(?:peak|pk|p)|0-p(?:ea)?k?|amplitude|half(?: of)? peak{_TO}peak"
_LINE = rf"{_END}(?:{_TO}|-){_END}|l-l|ph-ph|ll|between (?:two )?{_END}s|terminals?|line(?!{_TO}neutral)"
# word -> the spellings of it; the longer ones first, so that "peak-to-peak" is no "peak"
_SPELLED: dict[str, str] = {
    "amplitude": _HALF,
    "peak-to-peak": rf"peak{_TO}peak|peak-peak|pk{_TO}pk|pk-pk|p-p|pp|ss",
    "line": _LINE,
    "phase": rf"(?:line|phase){_TO}neutral|l-n|(?:per|of one|one|each)[\s-]+phase|phase",
    "rms": r"r\.m\.s\.?|rms|eff\.?|effective|(?<=[AV])[_ ]?(?:rms|eff)",
    "peak": r"peak|pk|crest|(?<=[AV])[_ ]?(?:peak|pk|p)",
    "dc": r"dc(?:[\s-]*(?:link|bus))?|direct|(?<=[AV])[_ ]?dc",
    "star": r"star|wye|y",
    "delta": r"delta|Δ",
    "of rated": r"of (?:the )?(?:rated|nominal)(?: torque)?",
    "unstated": r"unstated|not stated",
}
_WORDS = {
    word: re.compile(rf"(?:(?<![\w])|(?<=[AV])(?=rms|eff|peak|pk|p|dc|ll|0-p))(?:{spelled})(?![\w])", re.IGNORECASE)
    for word, spelled in _SPELLED.items()
}
_PLAIN = str.maketrans("‑–_", "-- ")
_FILLERS = re.compile(
    r"(?<![\w])(?:value|voltage|winding|connected|connection)(?![\w])|[,;()\[\]](?![\w/])", re.IGNORECASE
)
_PER_AMPERE = re.compile(r"(?<![\w])per\s+amp(?:ere)?s?(?![\w])", re.IGNORECASE)
DUTY = re.compile(r"(?<![\w])(S\d{1,2})(?:[\s\-–]*(\d+(?:\.\d+)?)\s*%)?(?![\w])")
TEMPERATURE = re.compile(r"(?:@|(?<![\w])at)\s*([+-]?\d+(?:\.\d+)?)\s*°?\s*C(?![\w])")
TOLERANCE = re.compile(r"(?:±|\+/-|\+-)\s*(\d+(?:\.\d+)?)\s*%")


def taken_apart(text: str) -> tuple[str, frozenset[str]]:
    """Return what is left of ``text`` without the words, and the words: ``("27.8 V/krpm", {"line", "rms"})``."""
    found, text = set(), text.translate(_PLAIN)
    for word, spelled in _WORDS.items():
        text, times = spelled.subn(" ", text)
        if times:
            found.add(word)
    text = _FILLERS.sub(" ", re.sub(r"\(\s*\)", " ", text))
    text = _PER_AMPERE.sub(" " if "/" in text else "/A", text)
    text = re.sub(r"(?<![\w])per(?![\w])", "/", text)
    return re.sub(r"\s+", " ", text).strip().rstrip("/ "), frozenset(found)
