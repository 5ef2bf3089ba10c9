"""The computing process: results, errors as they are, and a new process where one died."""

import os

import pytest

from tests.own_loop import awaited
from torquerig.errors import InputError, UnitError
from torquerig.studio.server.compute import Compute
from torquerig.units import parse_quantity


@pytest.fixture(scope="module")
def compute():
    made = Compute()
    yield made
    made.close()


def test_a_result_comes_from_another_process(compute):
    assert awaited(compute.run(os.getpid)) != os.getpid()
    assert awaited(compute.run(os.getppid)) == os.getpid()


def test_an_error_of_an_input_is_passed_on(compute):
    with pytest.raises(UnitError, match="3 N"):
        awaited(compute.run(parse_quantity, "3 N", "s"))


def test_an_error_of_the_program_is_said_as_one(compute):
    with pytest.raises(InputError, match=r"error in torquerig itself \(ValueError"):
        awaited(compute.run(int, "x"))


def test_a_process_that_died_is_replaced(compute):
    with pytest.raises(InputError, match="computing process ended"):
        awaited(compute.run(os._exit, 1))
    assert awaited(compute.run(abs, -3)) == 3
