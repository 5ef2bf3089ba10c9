// A Bokeh plot of long curves. The pyramid gives it what the view can show; a new result replaces the curves alone.

const COLUMN = 2; // [px] of a minimum and maximum: half the strokes of one pixel, which look the same
const ON_DARK = { "#0072b2": "#56b4e9", "#d55e00": "#f0a04b" }; // curves that are too dark there

function unpack(curve) {
  const text = atob(curve.codes), bytes = new Uint8Array(text.length), codes = new Uint16Array(bytes.buffer);
  for (let at = 0; at < text.length; at += 1) bytes[at] = text.charCodeAt(at);
  const values = new Float64Array(curve.samples);
  for (let at = 0; at < values.length; at += 1) {
    const value = curve.low + codes[at] * curve.size;
    values[at] = curve.logarithmic ? 10 ** value : value;
  }
  return makePyramid({ values, start: curve.start, step: curve.step });
}

// A colour as the page's scheme needs it, whichever of its two shades it is now.
function shade(colour) {
  const pair = Object.entries(ON_DARK).find((one) => one.includes(colour));
  return pair ? pair[matchMedia("(prefers-color-scheme: dark)").matches ? 1 : 0] : colour;
}

// Of each curve its lines with their width. A crowded curve is a band, as wide with the thinnest stroke, which browsers draw
// several times faster.
function linesOf(made, names) {
  const renderers = [...made._all_models.values()].filter((one) => one.type === "GlyphRenderer");
  return Object.fromEntries(names.map((name) => {
    const own = renderers.filter((one) => one.data_source === made.get_model_by_name(name));
    return [name, own.map(({ glyph }) => [glyph, glyph.line_width.value])];
  }));
}

function colour(made) {
  const style = getComputedStyle(document.documentElement);
  const ink = style.getPropertyValue("--ink").trim(), line = style.getPropertyValue("--line").trim();
  for (const model of made._all_models.values()) {
    const kind = model.type || "";
    if (kind.endsWith("Axis")) {
      model.setv({ axis_label_text_color: ink, major_label_text_color: ink, axis_line_color: line, major_tick_line_color: line, minor_tick_line_color: null, axis_label_text_font_style: "normal" });
    } else if (kind === "Grid") {
      model.grid_line_color = line;
    } else if (kind === "Line" && model.line_color && model.line_color.value) {
      model.line_color = { value: shade(model.line_color.value) };
    }
  }
}

export default {
  props: { name: String },
  data() {
    return { switches: [], hidden: {} };
  },
  template: `
    <div class="plot">
      <div class="curves" role="group" :aria-label="'curves: ' + name">
        <button v-for="one in switches" :key="one.text" type="button" :aria-pressed="hidden[one.text] ? 'false' : 'true'"
          title="show or hide" @click="toggle(one.text)">
          <i :style="{ borderTop: '3px ' + (one.dashed ? 'dashed ' : 'solid ') + one.colour }"></i>{{ one.text }}
        </button>
      </div>
      <div role="img" :aria-label="name"><div ref="place"></div></div>
    </div>`,
  mounted() {
    this.drawn = null;
    this.turn = Promise.resolve();
    this.scheme = matchMedia("(prefers-color-scheme: dark)");
    this.recolour = () => {
      if (!this.drawn) return;
      colour(this.drawn.document);
      this.switches = this.switches.map((one) => ({ ...one, colour: shade(one.colour) }));
    };
    this.scheme.addEventListener("change", this.recolour);
  },
  beforeUnmount() {
    this.scheme.removeEventListener("change", this.recolour);
    if (this.drawn) this.drawn.views.clear();
  },
  methods: {
    show(view) { // one after the other: a plot is embedded once
      this.turn = this.turn.then(() => this.draw(view)).catch((error) => console.error(error));
    },
    async draw(view) {
      await studioScripts;
      const item = JSON.stringify(view.item);
      if (!this.drawn || this.drawn.item !== item) await this.embed(view, item);
      const { document: made, range } = this.drawn;
      this.drawn.pyramids = Object.fromEntries(Object.entries(view.curves).map(([name, curve]) => [name, unpack(curve)]));
      const lines = made.get_model_by_name("lines"), y = made.get_model_by_name("y");
      if (lines && view.lines) lines.data = view.lines;
      if (y && view.y) y.setv({ start: view.y[0], end: view.y[1] });
      const whole = JSON.stringify(view.whole), first = JSON.stringify(view.first);
      if (this.drawn.whole !== whole || this.drawn.first !== first) {
        const moved = this.drawn.first && (range.start !== this.drawn.start || range.end !== this.drawn.end);
        if (!moved || this.drawn.whole !== whole) range.setv({ start: view.first[0], end: view.first[1], bounds: view.whole, reset_start: view.first[0], reset_end: view.first[1] });
        Object.assign(this.drawn, { whole, first, start: view.first[0], end: view.first[1] });
      }
      this.update();
      this.$el.dataset.drawn = String(Number(this.$el.dataset.drawn || 0) + 1);
    },
    async embed(view, item) {
      if (this.drawn) this.drawn.views.clear();
      this.$refs.place.replaceChildren();
      const views = await Bokeh.embed.embed_item(view.item, this.$refs.place);
      const made = views.get_by_id(view.item.root_id).model.document, range = made.get_model_by_name("x");
      this.drawn = { item, views, document: made, range, pyramids: {}, lines: linesOf(made, Object.keys(view.curves)) };
      this.switches = view.switches.map((one) => ({ ...one, colour: shade(one.colour) }));
      for (const one of this.switches) this.showCurve(one.text);
      let waits = false;
      const soon = () => { // both ends of the range first, and before the plot is painted
        if (waits) return;
        waits = true;
        queueMicrotask(() => { waits = false; this.update(); });
      };
      range.properties.start.change.connect(soon);
      range.properties.end.change.connect(soon);
      colour(made);
    },
    toggle(text) {
      this.hidden = { ...this.hidden, [text]: !this.hidden[text] };
      this.showCurve(text);
    },
    showCurve(text) {
      const renderer = this.drawn.document.get_model_by_name(text);
      if (renderer) renderer.visible = !this.hidden[text];
    },
    update() {
      const { document: made, range, pyramids, lines } = this.drawn;
      const columns = Math.max(Math.round((this.$el.clientWidth || 800) / COLUMN), 200);
      for (const [name, pyramid] of Object.entries(pyramids)) {
        const source = made.get_model_by_name(name), { x, y, crowded } = pyramidView(pyramid, range.start, range.end, columns);
        if (!source) continue;
        for (const [glyph, width] of lines[name]) glyph.line_width = { value: crowded ? 1 / devicePixelRatio : width };
        source.data = { x, y };
      }
    },
  },
};
