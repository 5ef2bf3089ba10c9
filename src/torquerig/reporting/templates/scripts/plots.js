"use strict";
// Plots of long curves: Bokeh draws, the pyramid gives it what the view can show.

const COLUMN = 2; // [px] of a minimum and maximum: half the strokes of one pixel, which look the same
const plotsOnPage = new Map(); // by id of the element: { curves, pyramids, document, update }

function readData(id) {
  return JSON.parse(document.getElementById(id).textContent);
}

let library = null; // the plotting library, once it is asked for

function loadLibrary() {
  library = library || unpacked(document.getElementById("plot-library").textContent).text().then((text) => {
    const made = document.createElement("script");
    made.textContent = text;
    document.head.append(made);
  });
  return library;
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
  const plot = Promise.all([plotData(id), loadLibrary()]).then(async ([{ data, curves }]) => {
    const pyramids = Object.fromEntries(Object.entries(curves).map(([name, curve]) => [name, makePyramid(curve)]));
    const views = await Bokeh.embed.embed_item(data.item, id);
    const view = views.get_by_id ? views.get_by_id(data.item.root_id) : views.roots[0], made = view.model.document;
    const range = made.get_model_by_name("x");
    const host = document.getElementById(id);
    const drawn = Object.entries(pyramids).map(([name, pyramid]) => [made.get_model_by_name(name), pyramid, linesOf(made, name)]);
    const update = () => {
      const columns = Math.max(Math.round((host.clientWidth || 800) / COLUMN), 200);
      for (const [source, pyramid, lines] of drawn) {
        if (!source) continue;
        const { x, y, crowded } = pyramidView(pyramid, range.start, range.end, columns);
        for (const [line, width] of lines) line.line_width = { value: crowded ? 1 / devicePixelRatio : width };
        source.data = { x, y };
      }
    };
    const soon = oncePerFrame(update);
    range.properties.start.change.connect(soon);
    range.properties.end.change.connect(soon);
    update();
    keepLayout(view);
    host.before(curveSwitches(data.legend, made));
    colourPlot(made, host);
    host.closest("figure").classList.add("moves");
    return { data, curves, pyramids, document: made, range, update };
  });
  plotsOnPage.set(id, plot);
  return plot;
}

// Lines drawn from a source, with the width of a curve that is not crowded. A crowded one is a band, as wide with the
// thinnest stroke, which browsers draw several times faster than wider ones.
function linesOf(made, name) {
  const source = made.get_model_by_name(name);
  const renderers = [...made._all_models.values()].filter((one) => one.type === "GlyphRenderer" && one.data_source === source);
  return renderers.map(({ glyph }) => [glyph, glyph.line_width.value]);
}

const REST = 250; // [ms] without a change, after which labels may take more room
let lastChange = 0;

// At once where the last change is a frame ago, so that curves and axes move together; else once in the next frame; and
// once more at rest, for labels that need more room.
function oncePerFrame(update) {
  let waits = false, again = false, rest = 0;
  const frame = () => {
    waits = again;
    if (!again) return;
    again = false;
    requestAnimationFrame(frame);
    update();
  };
  return () => {
    lastChange = performance.now();
    clearTimeout(rest);
    rest = setTimeout(update, REST + 1);
    if (waits) { again = true; return; }
    waits = true;
    requestAnimationFrame(frame);
    queueMicrotask(update); // both ends of the range first, and before the plot is painted
  };
}

// Axes may grow at rest and do not shrink: each new layout, for a label of other width, takes as long as drawing.
function keepLayout(view) {
  const seen = new Set();
  const visit = (one) => {
    if (!one || seen.has(one)) return;
    seen.add(one);
    if (one.panel && one.layout && one.layout.has_size_changed) {
      Object.getPrototypeOf(one.layout).has_size_changed = function grown() {
        if (performance.now() - lastChange < REST) return false;
        const { width, height } = this._content_size();
        return this.panel.is_horizontal ? height > this.bbox.height : width > this.bbox.width;
      };
    }
    [...(one.child_views || []), ...(one.renderer_views ? one.renderer_views.values() : [])].forEach(visit);
  };
  visit(view);
}

// A button for each curve, which the keyboard reaches; the library's legend is drawn anew with every change of data.
function curveSwitches(entries, made) {
  const switches = entries.map(({ text, colour, dashed, renderers }) => {
    const swatch = element("i", { "data-colour": colour, style: `border-top-style:${dashed ? "dashed" : "solid"}` });
    const button = element("button", { type: "button", "aria-pressed": "true", title: "show or hide" }, swatch, text);
    button.addEventListener("click", () => {
      const shown = button.getAttribute("aria-pressed") !== "true";
      button.setAttribute("aria-pressed", `${shown}`);
      for (const name of renderers) { const one = made.get_model_by_name(name); if (one) one.visible = shown; }
    });
    return button;
  });
  return element("div", { class: "curves", role: "group", "aria-label": "curves" }, ...switches);
}

const ON_DARK = { "#0072b2": "#56b4e9", "#d55e00": "#f0a04b" }; // curves that are too dark there

function colourPlot(made, host) {
  const style = getComputedStyle(document.documentElement);
  const dark = matchMedia("(prefers-color-scheme: dark)").matches;
  const shadeOfCurve = (colour) => {
    const [light, shade] = Object.entries(ON_DARK).find((pair) => pair.includes(colour)) || [colour, colour];
    return dark ? shade : light;
  };
  const ink = style.getPropertyValue("--ink").trim(), line = style.getPropertyValue("--line").trim();
  for (const model of made._all_models.values()) {
    if (model.type && model.type.endsWith("Axis")) {
      model.setv({ axis_label_text_color: ink, major_label_text_color: ink, axis_line_color: line, major_tick_line_color: line, minor_tick_line_color: null, axis_label_text_font_style: "normal" });
    } else if (model.type === "Grid") {
      model.grid_line_color = line;
    } else if (model.type === "Line" && model.line_color && model.line_color.value) {
      model.line_color = { value: shadeOfCurve(model.line_color.value) };
    }
  }
  for (const one of host.parentElement.querySelectorAll("[data-colour]")) one.style.borderTopColor = shadeOfCurve(one.dataset.colour);
}

function wholeRange(id) {
  plotsOnPage.get(id).then(({ range, data }) => range.setv({ start: data.range[0], end: data.range[1] }));
}

function startPlots() {
  const scheme = matchMedia("(prefers-color-scheme: dark)");
  const recolour = (plot, id) => plot.then((one) => colourPlot(one.document, document.getElementById(id)));
  scheme.addEventListener("change", () => plotsOnPage.forEach(recolour));
  const watch = new IntersectionObserver((seen) => { // what is folded or far below waits until it comes near
    for (const { target } of seen.filter((one) => one.isIntersecting)) {
      watch.unobserve(target);
      openPlot(target.querySelector("[data-plot]").id);
    }
  }, { rootMargin: "300px" });
  document.querySelectorAll("figure:has([data-plot])").forEach((figure) => watch.observe(figure));
}
