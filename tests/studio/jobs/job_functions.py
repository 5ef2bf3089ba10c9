"""Functions that the tests of jobs run in another process."""

import multiprocessing
import os
import subprocess
import sys
import time
from pathlib import Path

from torquerig.errors import InputError


def counted(count, report):
    sys.stdout.write("on standard output, which is the pipe of the results\n")
    for place in range(count):
        report(done=place + 1, total=count, name=f"step {place + 1}")
    return list(range(count))


def refused(report):
    raise InputError("run.csv: has no torque; name one")


def broken(report):
    return {}["x"]


def ended(report):
    os._exit(3)


def with_a_child(file, report):
    child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"])
    Path(f"{file}.new").write_text(str(child.pid))
    Path(f"{file}.new").rename(file)
    time.sleep(600)


def with_forked_workers(report):
    with multiprocessing.get_context("fork").Pool(2) as pool:
        return pool.map(abs, [-1, -2])


def killed_with_a_forked_worker(report):
    multiprocessing.get_context("fork").Process(target=time.sleep, args=(10,)).start()
    os.kill(os.getpid(), 9)
