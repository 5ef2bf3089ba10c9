"use strict";
// Sliders and fields for weights, limits and points; each change computes the matrices again.

function unitText(unit) {
  return unit === "1" || unit === "yes/no" ? "" : ` [${unit.replace("*", " ")}]`;
}

function numberField(label, value, attributes, changed) {
  const input = element("input", { type: "number", step: "any", value: value === null ? "" : value, "aria-label": label, ...attributes });
  input.addEventListener("input", () => {
    const number = input.value === "" ? null : Number(input.value);
    const message = input.validity.valid ? changed(number) : input.validationMessage;
    input.setCustomValidity(message || "");
    input.setAttribute("aria-invalid", message ? "true" : "false");
    input.title = message || "";
  });
  return input;
}

function weightRow(model, at, changed) {
  const criterion = model.criteria[at], label = `weight of ${criterion.name}`;
  const most = Math.max(1, ...model.criteria.map((one) => one.weight));
  const slider = element("input", { type: "range", min: 0, max: most, step: "any", value: criterion.weight, "aria-label": label });
  const field = numberField(`${label}, number`, criterion.weight, { min: 0 }, (value) => {
    if (value === null) return "write a number of at least 0";
    slider.value = value;
    return changed(() => { criterion.weight = value; });
  });
  slider.addEventListener("input", () => {
    field.value = Number(Number(slider.value).toPrecision(3));
    changed(() => { criterion.weight = Number(field.value); });
  });
  return element("div", { class: "control" }, element("span", { text: criterion.name + unitText(criterion.unit) }), slider, field);
}

function knotsProblem(knots, better) {
  let fell = false;
  for (let at = 1; at < knots.length; at += 1) {
    const step = knots[at][1] - knots[at - 1][1];
    if (better === "more" && step < 0) return "more is better, so the points may not fall";
    if (better === "less" && step > 0) return "less is better, so the points may not rise";
    if (better === "band" && fell && step > 0) return "a band is best, so the points may not rise again after they fell";
    fell = fell || step < 0;
  }
  return "";
}

function pointsRow(model, at, changed) {
  const criterion = model.criteria[at], { min, max } = model.profile;
  const fields = criterion.knots.map(([value], knot) => {
    const label = `points of ${criterion.name} at ${value}`;
    const field = numberField(label, criterion.knots[knot][1], { min, max }, (points) => {
      if (points === null) return `write points from ${min} to ${max}`;
      const before = criterion.knots[knot][1];
      criterion.knots[knot][1] = points;
      const problem = knotsProblem(criterion.knots, criterion.better);
      if (problem) criterion.knots[knot][1] = before;
      return problem || changed(() => {});
    });
    return element("label", { class: "knot" }, element("span", { text: `${value}` }), field);
  });
  return element("div", { class: "control knots" }, element("span", { text: criterion.name + unitText(criterion.unit) }), element("div", {}, ...fields));
}

function limitRow(model, at, changed) {
  const limit = model.requirements[at];
  const end = (which, word) => (limit[which] === null ? null : element("label", { class: "knot" }, element("span", { text: word }),
    numberField(`${word} of ${limit.name}`, limit[which], {}, (value) => {
      if (value === null) return "write a number";
      return changed(() => { limit[which] = value; });
    })));
  return element("div", { class: "control knots" }, element("span", { text: limit.name + unitText(limit.unit) }),
    element("div", {}, end("low", "at least"), end("high", "at most")));
}

// Ratios of the drives, rising, as their names end with: "5:1", "2.5:1 of 12.5:1".
function ratiosOf(groups) {
  const found = groups.map((name) => (name.match(/[\d.]+:1(?: of [\d.]+:1)?$/) || [""])[0]).filter(Boolean);
  return [...new Set(found)].sort((one, other) => parseFloat(one.split(" of ").pop()) - parseFloat(other.split(" of ").pop()));
}

function ratioRow(state, render) {
  const texts = ["all", ...ratiosOf(state.model.groups)];
  if (texts.length < 3) return null;
  const output = element("output", { text: state.ratio || "all" });
  const slider = element("input", { type: "range", min: 0, max: texts.length - 1, step: 1, value: Math.max(texts.indexOf(state.ratio), 0), "aria-label": "ratio of the drives in ranking and S-diagram", "aria-valuetext": state.ratio || "all" });
  slider.addEventListener("input", () => {
    const text = texts[Number(slider.value)];
    state.ratio = slider.value === "0" ? "" : text;
    output.textContent = text;
    slider.setAttribute("aria-valuetext", text);
    render();
  });
  return element("div", { class: "control" }, element("span", { text: "ratio" }), slider, output);
}

function startMatrices() {
  const host = document.getElementById("matrix-controls");
  if (!host) return;
  const state = { model: readMatrix(), data: MATRIX_DATA, stated: solveMatrices(readMatrix()), ratio: "" };
  const render = () => {
    const solved = solveMatrices(state.model);
    if (solved.overall === null) return "all weights are 0; give at least one criterion a weight above 0";
    showMatrices(state.model, solved, state.stated, state.ratio);
    return "";
  };
  const changed = (edit) => {
    const before = JSON.parse(JSON.stringify(state.model));
    edit();
    const problem = render();
    if (problem) Object.assign(state.model, before);
    document.getElementById("matrix-problem").textContent = problem;
    return problem;
  };
  const build = () => {
    const groups = [
      ["Drives that the study computed", [ratioRow(state, render)]],
      ["Weights", state.model.criteria.map((one, at) => (one.knots ? weightRow(state.model, at, changed) : null))],
      ["Limits", state.model.requirements.map((_, at) => limitRow(state.model, at, changed))],
      ["Points", state.model.criteria.map((one, at) => (one.knots && one.weight > 0 ? pointsRow(state.model, at, changed) : null))],
    ];
    host.replaceChildren(
      ...groups.filter(([, rows]) => rows.some(Boolean)).map(([title, rows]) => element("fieldset", {}, element("legend", { text: title }), ...rows)),
      element("button", { type: "button", id: "matrix-reset", text: "Back to the stated values", onclick: () => { Object.assign(state, { model: readMatrix(state.data), ratio: "" }); build(); render(); } }),
    );
  };
  build();
  render();
  // The results of another point of a sweep; weights, limits and points stay as they are set.
  const use = (data, text) => {
    const { criteria, requirements } = state.model, model = readMatrix(data);
    model.criteria.forEach((one, at) => Object.assign(one, { weight: criteria[at].weight, knots: criteria[at].knots }));
    model.requirements.forEach((one, at) => Object.assign(one, { low: requirements[at].low, high: requirements[at].high }));
    Object.assign(state, { model, data, stated: solveMatrices(readMatrix(data)) });
    build();
    render();
    document.getElementById("matrix-point").textContent = `Results at ${text}, the point of the sweep.`;
  };
  window.torquerigMatrices = { state, changed, render, use };
}

const MATRIX_DATA = "data-matrix";

function readMatrix(id = MATRIX_DATA) {
  return JSON.parse(document.getElementById(id).textContent);
}
