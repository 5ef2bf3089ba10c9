"""The studio in Chromium: first plot after the start, latency of a change until it is painted, memory.

python benchmarks/studio.py [CHANGES]    needs the extra studio, playwright and a Chromium in PATH

A change is another motor, speed, load or filter: 2 s of the wear rig by the integrator, filtered, sized and drawn.
Prints wall times, and the CPU time of the studio's two processes for each, which counts on a machine that computes
other things too. Memory is what the two processes hold of their own (proportional set size) after all changes.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from playwright.sync_api import sync_playwright

from torquerig.catalog.shipped import shipped_scenarios

CHANGES = 200
STARTS = 3
TICKS = os.sysconf("SC_CLK_TCK")
MOTORS = ("HDS6A-0104A", "bldc-12n14p", "HDS60-0104A", "ESM04X-101-302")
FILTERS = ("order_lines_low_pass", "low_pass_20Hz", "report_filter_code", "none")
DRAWN = """(after) => {
  const plots = [...document.querySelectorAll('.plot')];
  return plots.length === 2 && plots.every((one) => Number(one.dataset.drawn || 0) > after);
}"""
# the value is set as a person leaves the field; painted: the frame after both plots have the new curves
CHANGE = """async ([label, value]) => {
  const found = [...document.querySelectorAll('label')].find((one) => one.innerText === label);
  const entry = document.getElementById(found.htmlFor), plots = [...document.querySelectorAll('.plot')];
  const size = document.querySelector('#what-if-sizing').parentElement, before = plots.map((one) => one.dataset.drawn);
  const start = performance.now(), frame = () => new Promise((done) => requestAnimationFrame(done));
  entry.value = value;
  entry.dispatchEvent(new Event('change'));
  while (plots.some((one, at) => one.dataset.drawn === before[at])) await frame();
  await new Promise((done) => requestAnimationFrame(() => setTimeout(done, 0)));
  const painted = performance.now() - start;
  while (size.dataset.shown === window.lastSized) await frame();
  window.lastSized = size.dataset.shown;
  return [painted, performance.now() - start];
}"""


class Studio:
    """A studio of a folder with the wear rig, and its two processes."""

    def __init__(self, folder):
        for name in ("wear_rig.yaml", "filters.yaml"):
            shutil.copy(shipped_scenarios() / name, folder)
        command = [sys.executable, "-m", "torquerig", "studio", str(Path(folder) / "wear_rig.yaml"), "--no-browser"]
        env = os.environ | {"PYTHONUNBUFFERED": "1"}
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=env)
        self.address = re.search(r"http://\S+", self.process.stdout.readline())[0]

    def processes(self):
        """Return the ids of the server and of what it started."""
        found = Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children").read_text().split()
        return [self.process.pid, *map(int, found)]

    def cpu(self):
        """Return the CPU time of all processes [s]."""
        stats = [Path(f"/proc/{one}/stat").read_text().rpartition(")")[2].split() for one in self.processes()]
        return sum(int(one[11]) + int(one[12]) for one in stats) / TICKS

    def memory(self):
        """Return the memory of all processes [MB], what they share counted once."""
        texts = [Path(f"/proc/{one}/smaps_rollup").read_text() for one in self.processes()]
        return sum(int(re.search(r"Pss:\s+(\d+)", one)[1]) for one in texts) / 1024

    def end(self):
        """End it."""
        self.process.terminate()
        self.process.wait(20)


def started(browser, folder):
    """Start a studio and open it; return both and the times until address and first plot [s]."""
    begin = time.perf_counter()
    studio = Studio(folder)
    printed = time.perf_counter() - begin
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.goto(f"{studio.address}&step=what_if")
    page.wait_for_function(DRAWN, arg=0, timeout=120_000)
    return studio, page, printed, time.perf_counter() - begin


def change_of(number):
    """Return the field and the value of a change; every one asks for another simulation or another filter."""
    return [
        ("output speed", f"{150 + number} rpm"), ("motor", MOTORS[number // 4 % len(MOTORS)]),
        ("occupancy", f"{5 + number % 13} %"), ("filter", FILTERS[number // 4 % len(FILTERS)]),
    ][number % 4]  # fmt: skip


def row(name, values):
    """Print median, 95th percentile and maximum [ms]."""
    found = 1e3 * np.array(values)
    print(f"{name:34s} [ms] {np.median(found):7.0f}  95 %: {np.percentile(found, 95):.0f}  most: {found.max():.0f}")


def main():
    changes = int(sys.argv[1]) if len(sys.argv) > 1 else CHANGES
    print(f"load of the machine: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        printed, drawn, cpu = [], [], []
        for at in range(STARTS):
            studio, page, first, second = started(browser, folder)
            printed.append(first), drawn.append(second), cpu.append(studio.cpu())
            if at < STARTS - 1:
                page.close()
                studio.end()
        for name, values in (("start to address", printed), ("start to first plot", drawn), ("CPU of a start", cpu)):
            row(name, values)
        page.wait_for_function("document.querySelector('#what-if-sizing').parentElement.dataset.shown")
        page.evaluate("window.lastSized = document.querySelector('#what-if-sizing').parentElement.dataset.shown")
        painted, sized, begin = [], [], studio.cpu()
        for number in range(changes):
            first, second = page.evaluate(CHANGE, change_of(number))
            painted.append(first / 1e3), sized.append(second / 1e3)
        row("change to painted plots", painted)
        row("change to painted plots and sizing", sized)
        print(f"{'CPU of a change':34s} [ms] {1e3 * (studio.cpu() - begin) / changes:7.0f}  (mean)")
        print(f"{'memory after the changes':34s} [MB] {studio.memory():7.0f}")
        browser.close()
        studio.end()


if __name__ == "__main__":
    main()
