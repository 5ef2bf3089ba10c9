"""What a wheel must carry: the catalogs and scenarios, beside the package or in it."""

from __future__ import annotations

import tomllib
from pathlib import Path

from torquerig.catalog.shipped import shipped_folder, shipped_scenarios

ROOT = Path(__file__).resolve().parents[2]


def test_the_wheel_takes_both_folders_to_where_the_package_looks() -> None:
    stated = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    taken = stated["tool"]["hatch"]["build"]["targets"]["wheel"]["force-include"]
    assert taken == {"catalogs": "torquerig/shipped/catalogs", "scenarios": "torquerig/shipped/scenarios"}
    assert all((ROOT / name).is_dir() for name in taken)


def test_the_shipped_folders_are_there() -> None:
    assert {"motors", "gearboxes", "sensors", "couplings"} <= {path.name for path in shipped_folder().iterdir()}
    assert {"wear_rig.yaml", "filters.yaml", "reference_tables.yaml"} <= {
        path.name for path in shipped_scenarios().iterdir()
    }
