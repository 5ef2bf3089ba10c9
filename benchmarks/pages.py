"""Pages in Chromium: from opening to ready, and the latency of zoom and slider on a million samples a curve.

python benchmarks/pages.py [SAMPLES]    needs playwright and a Chromium in PATH

Prints the time from opening to the mark that the page sets when everything reacts, and to the first drawn plot;
then the median, 95th percentile and maximum of 200 zooms and 200 moves of a slider, until the browser has painted,
and the CPU time of the page's main thread for each, which counts on a machine that computes other things too.
"""

import shutil
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from playwright.sync_api import sync_playwright

from torquerig.catalog.reading import load_catalog
from torquerig.catalog.shipped import shipped_folder, shipped_scenarios
from torquerig.document import read_document
from torquerig.metrics.truth_error import TRUE_LOAD
from torquerig.recordings.recording import Channel, Recording
from torquerig.recordings.run import Run
from torquerig.reporting.study.page import study_page
from torquerig.scenario.overrides import overridden
from torquerig.study.definition import open_study
from torquerig.study.run_study import run_study
from torquerig.study.scoring import decide
from torquerig.study.verdict import verdict

SMALL = ("study.duration=2 s", "study.draws=1")
RATE = 25_000.0
CHANGES = 200
STEP = 20 / 2**16  # [V] of the rig's converter

PAINTED = """async (change) => {
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const start = performance.now();
  change();
  await new Promise((done) => requestAnimationFrame(() => setTimeout(done, 0)));
  return performance.now() - start;
}"""
ZOOMS = f"""async (count) => {{
  const painted = {PAINTED}, plot = await openPlot('plot-reading'), end = plot.data.range[1], found = [];
  for (let at = 0; at < count; at += 1) {{
    const width = end * (0.001 + 0.999 * ((at * 37) % 100) / 100), start = (end - width) * ((at * 61) % 100) / 100;
    found.push(await painted(() => plot.range.setv({{ start, end: start + width }})));
  }}
  return found;
}}"""
SLIDES = f"""async (count) => {{
  document.getElementById('try').open = true;
  const painted = {PAINTED}, sliders = [...document.querySelectorAll('#matrix-controls input[type=range]')], found = [];
  for (let at = 0; at < count; at += 1) {{
    const slider = sliders[at % sliders.length];
    const move = () => {{ slider.value = ((at * 29) % 100) / 100; slider.dispatchEvent(new Event('input')); }};
    found.push(await painted(move));
  }}
  return found;
}}"""


def long_recording(samples):
    """A reading of noise, lines and a slow load, as long as asked."""
    rng, time = np.random.default_rng(1), np.arange(samples) / RATE
    load = 1 + 0.1 * np.sin(2 * np.pi * 1.5 * time)
    reading = load + 0.1 * np.sin(2 * np.pi * 116.7 * time) + 0.02 * rng.standard_normal(samples)
    reading = STEP * np.round(reading / STEP)
    channels = {
        "torque_V": Channel(values=reading, quantity="torque", unit="V"),
        TRUE_LOAD: Channel(values=load, quantity="torque", unit="N*m", truth=True),
    }
    return Recording(sample_rate=RATE, channels=channels, run=Run(speed=104.7, gear_ratio=5.0), name="long")


def page_of(samples):
    document = overridden(read_document(shipped_scenarios() / "wear_rig.yaml"), SMALL)
    runs = run_study(open_study(document, load_catalog(shipped_folder())))
    reading = long_recording(samples)
    drives = tuple(replace(one, simulated=lambda: reading) if one.chains else one for one in runs.drives)
    runs = replace(runs, drives=drives)
    decided = decide(runs)
    return study_page(runs, decided, verdict(decided))


def main():
    samples = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as started:
        file = Path(folder) / "index.html"
        file.write_text(page_of(samples), encoding="utf-8")
        print(f"{samples} samples a curve, page {file.stat().st_size / 1e6:.1f} MB")
        browser = started.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        opened = [measured(browser, file) for _ in range(5)]
        for name in opened[0]:
            print(f"{name:24s} [ms] {np.median([one[name] for one in opened]):7.0f}  (median of 5)")
        page = browser.new_page(viewport={"width": 1280, "height": 900})
        page.goto(file.as_uri())
        page.evaluate("openPlot('plot-reading').then(() => null)")
        clock = page.context.new_cdp_session(page)
        clock.send("Performance.enable", {"timeDomain": "threadTicks"})
        for name, script in (("zoom, two plots", ZOOMS), ("slider, all matrices", SLIDES)):
            start = busy(clock)
            found = np.array(page.evaluate(script, CHANGES))
            cpu = 1e3 * (busy(clock) - start) / CHANGES
            ends = f"95 %: {np.percentile(found, 95):.1f}  most: {found.max():.1f}  CPU: {cpu:.1f}"
            print(f"{name:24s} [ms] {np.median(found):7.1f}  {ends}")
        browser.close()


def busy(clock):
    """CPU time of the page's main thread [s]."""
    return next(
        one["value"] for one in clock.send("Performance.getMetrics")["metrics"] if one["name"] == "TaskDuration"
    )


def measured(browser, file):
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.goto(file.as_uri())
    ready = page.evaluate("performance.getEntriesByName('torquerig-ready')[0].startTime")
    drawn = page.evaluate("openPlot('plot-reading').then(() => performance.now())")
    page.close()
    return {"open to ready": ready, "open to first plot": drawn}


if __name__ == "__main__":
    main()
