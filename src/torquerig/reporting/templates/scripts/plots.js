"use strict";
// Plots of long curves: Bokeh draws, the pyramid gives it what the view can show.

const COLUMN = 2; // [px] of a minimum and maximum: half the strokes of one pixel, which look the same
const plotsOnPage = new Map(); // by id of the element: { curves, pyramids, document, update }

function readData(id) {
  return JSON.parse(document.getElementById(id).textContent);
}

async function plotData(id) {
  const data = readData(`data-${id}`);
  const curves = {};
  for (const [name, packed] of Object.entries(data.curves)) curves[name] = await unpackCurve(packed);
  for (const [name, [minuend, subtrahend]] of Object.entries(data.differences)) {
    const one = curves[minuend], other = curves[subtrahend];
    curves[name] = { ...one, values: one.values.map((value, at) => value - other.values[at]) };
  }
  return { data, curves };
}

async function openPlot(id) {
  if (plotsOnPage.has(id)) return plotsOnPage.get(id);
  const plot = plotData(id).then(async ({ data, curves }) => {
    const pyramids = Object.fromEntries(Object.entries(curves).map(([name, curve]) => [name, makePyramid(curve)]));
    const views = await Bokeh.embed.embed_item(data.item, id);
    const made = views.get_by_id ? views.get_by_id(data.item.root_id).model.document : views.roots[0].model.document;
    const range = made.get_model_by_name("x");
    const host = document.getElementById(id);
    const update = () => {
      const columns = Math.max(Math.round((host.clientWidth || 800) / COLUMN), 200);
      for (const [name, pyramid] of Object.entries(pyramids)) {
        const source = made.get_model_by_name(name);
        if (source) source.data = pyramidView(pyramid, range.start, range.end, columns);
      }
    };
    let waits = false;
    const soon = () => {
      if (waits) return;
      waits = true;
      queueMicrotask(() => { waits = false; update(); }); // both ends of the range first, and before the plot is painted
    };
    range.properties.start.change.connect(soon);
    range.properties.end.change.connect(soon);
    update();
    colourPlot(made);
    host.closest("figure").classList.add("moves");
    return { data, curves, pyramids, document: made, range, update };
  });
  plotsOnPage.set(id, plot);
  return plot;
}

const ON_DARK = { "#0072b2": "#56b4e9", "#d55e00": "#f0a04b" }; // curves that are too dark there

function colourPlot(made) {
  const style = getComputedStyle(document.documentElement);
  const dark = matchMedia("(prefers-color-scheme: dark)").matches, narrow = document.documentElement.clientWidth < 600;
  const ink = style.getPropertyValue("--ink").trim(), line = style.getPropertyValue("--line").trim();
  for (const model of made._all_models.values()) {
    if (model.type && model.type.endsWith("Axis")) {
      model.setv({ axis_label_text_color: ink, major_label_text_color: ink, axis_line_color: line, major_tick_line_color: line, minor_tick_line_color: null, axis_label_text_font_style: "normal" });
    } else if (model.type === "Grid") {
      model.grid_line_color = line;
    } else if (model.type === "Legend") {
      model.setv({ label_text_color: ink, background_fill_color: null, label_text_font_size: "12px", orientation: narrow ? "vertical" : "horizontal" });
    } else if (model.type === "Line" && model.line_color && model.line_color.value) {
      const [light, shade] = Object.entries(ON_DARK).find((pair) => pair.includes(model.line_color.value)) || [];
      if (light) model.line_color = { value: dark ? shade : light };
    }
  }
}

function wholeRange(id) {
  plotsOnPage.get(id).then(({ range, data }) => range.setv({ start: data.range[0], end: data.range[1] }));
}

function startPlots() {
  const scheme = matchMedia("(prefers-color-scheme: dark)");
  scheme.addEventListener("change", () => plotsOnPage.forEach((plot) => plot.then((one) => colourPlot(one.document))));
  for (const host of document.querySelectorAll("[data-plot]")) {
    const folded = host.closest("details");
    if (folded && !folded.open) folded.addEventListener("toggle", () => folded.open && openPlot(host.id));
    else openPlot(host.id);
  }
}
