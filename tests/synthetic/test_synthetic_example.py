"""The shipped example is read and mixed."""

from torquerig.catalog.shipped import shipped_scenarios
from torquerig.synthetic.description import read_mixture


def test_the_example_describes_a_mixture() -> None:
    mixture = read_mixture(shipped_scenarios() / "mixture_example.yaml")
    assert {one.part for one in mixture.components.values()} == {"load", "noise"}
    assert mixture.seed == 1
