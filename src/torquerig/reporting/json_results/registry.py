"""The result class of each command, by the name in the schema of its JSON."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module

_WRITTEN = "simulate:WrittenResult"
RESULTS: Mapping[str, str] = {
    "batch": "batch:BatchResult",
    "cache": "cache:CacheResult",
    "catalog-check": "catalog:CatalogCheckResult",
    "catalog-export": _WRITTEN,
    "catalog-import": _WRITTEN,
    "catalog-list": "catalog:CatalogListResult",
    "catalog-new": _WRITTEN,
    "catalog-show": "catalog:CatalogShowResult",
    "compare": "compare:CompareResult",
    "compare-points": "compare:ComparePointsResult",
    "diagnose-check": "diagnosis:DiagnoseCheckResult",
    "differ": "differ:DifferResult",
    "duty": "sizing:DutyResult",
    "filter": "filter:FilterResult",
    "info": "info:InfoResult",
    "init": _WRITTEN,
    "join": _WRITTEN,
    "matrix": "matrix:MatrixResult",
    "modes": "modes:ModesResult",
    "optimise": "draws:OptimiseResult",
    "ordermap": "ordermap:OrdermapResult",
    "orders": "orders:OrdersResult",
    "reference-decision": "reference:ReferenceDecisionResult",
    "reference-results": "reference:ReferenceResultsResult",
    "sheet": _WRITTEN,
    "simulate": "simulate:SimulateResult",
    "size": "sizing:SizeResult",
    "study": "draws:StudyResult",
    "synth-control": _WRITTEN,
    "synth-effects": _WRITTEN,
    "synth-fault": _WRITTEN,
    "synth-mixture": _WRITTEN,
    "synth-pair": _WRITTEN,
    "synth-sweep": _WRITTEN,
}


def result_class(name: str) -> type:
    """Return the dataclass of a result by the name in its schema, which is a key of ``RESULTS``."""
    module, _, attribute = RESULTS[name].partition(":")
    found: type = getattr(import_module(f"torquerig.reporting.json_results.{module}"), attribute)
    return found
