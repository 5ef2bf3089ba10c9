"use strict";
// The results of the matrices as tables and S-diagram.

const WORSE = [245, 184, 115], BETTER = [125, 181, 224]; // as reporting/figures/shades.py
const MARK_COLOURS = { "+": "#cfe3f4", "-": "#fbdcbc", "?": "#fdf0c4", "!": "#e6d9f2", S: "#eceff1" };
const MOST_RANKED = 15; // rows of the ranking; the other tables have all

function shadeOf(value, low, high) {
  const place = high > low ? Math.min(Math.max((value - low) / (high - low), 0), 1) : 0.5;
  const [end, share] = place < 0.5 ? [WORSE, 1 - 2 * place] : [BETTER, 2 * place - 1];
  return `background:rgb(${end.map((part) => Math.round(255 + share * (part - 255))).join(",")});color:#000`;
}

function plainNumber(value, digits = 3) {
  return Number(value.toPrecision(digits)).toString();
}

function spanText(low, high, digits = 3) {
  const ends = [plainNumber(low, digits), plainNumber(high, digits)];
  return ends[0] === ends[1] ? ends[0] : ends.join("..");
}

function rankText(rank, best, worst) {
  return best === worst ? `${rank}` : `${rank} (${best}..${worst})`;
}

function cellOf(text, attributes) {
  return element("td", { text, ...attributes });
}

// Fill a table, with rows from `made`; one that is folded away waits until its section opens.
function fillTable(id, head, made) {
  const table = document.getElementById(id), folded = table && table.closest("details:not([open])");
  if (!table) return;
  if (folded) { folded.ontoggle = () => { folded.ontoggle = null; fillTable(id, head, made); }; return; }
  const rows = made();
  const headings = head.map(([text, isNumber]) => element("th", { scope: "col", text, class: isNumber ? "number" : null }));
  table.tHead.replaceChildren(element("tr", {}, ...headings));
  table.tBodies[0].replaceChildren(...rows);
  sortable(table);
}

function bodyRow(name, cells, isBold) {
  return element("tr", { class: isBold ? "bold" : null }, element("th", { scope: "row", text: name }), ...cells);
}

function showMatrices(model, solved, stated, ratio = "") {
  const kept = solved.ranked.filter((at) => hasRatio(model, solved.rows[at], ratio));
  showWinner(model, solved, stated, ratio, kept);
  showRanking(model, solved, kept);
  showElimination(model, solved);
  showPugh(model, solved);
  showPoints(model, solved);
  drawStrength(model, solved, ratio);
}

function hasRatio(model, row, ratio) {
  const name = model.groups[model.rows[row].group];
  return !ratio || name === ratio || name.endsWith(` ${ratio}`);
}

function showWinner(model, solved, stated, ratio, kept) {
  const before = stated.winner, host = document.getElementById("matrix-winner");
  if (solved.winner === null) { host.textContent = "No alternative meets these requirements."; return; }
  const name = model.rows[solved.winner].name, share = solved.overall.share[solved.rows.indexOf(solved.winner)];
  const same = before === solved.winner ? "as with the stated values" : `with the stated values it is ${before === null ? "none" : model.rows[before].name}`;
  const of = ratio && (kept.length ? `${model.rows[solved.rows[kept[0]]].name}, T/T_max ${solved.overall.share[kept[0]].toFixed(3)}` : "no drive meets the requirements");
  host.textContent = `First: ${name}, T/T_max ${share.toFixed(3)}; ${same}.${ratio ? ` With ratio ${ratio}: ${of}.` : ""}`;
}

function showRanking(model, solved, kept) {
  const found = solved.overall;
  const shown = kept.slice(0, MOST_RANKED);
  const baseline = solved.rows.indexOf(model.baseline);
  if (baseline >= 0 && !shown.includes(baseline)) shown.push(baseline);
  const rows = () => shown.map((at) => bodyRow(model.rows[solved.rows[at]].name, [
    cellOf(rankText(found.ranks[at], found.range.best[at], found.range.worst[at]), { class: "number" }),
    cellOf(found.share[at].toFixed(3), { class: "number", style: shadeOf(found.share[at], 0.4, 1) }),
    cellOf(spanText(found.low[at] / found.ideal, found.high[at] / found.ideal, 2), { class: "number" }),
    cellOf(solved.chart[model.rows[solved.rows[at]].group].decision),
  ], solved.rows[at] === solved.winner || at === baseline));
  fillTable("live-ranking", [["alternative"], ["rank", true], ["T/T_max", true], ["range", true], ["requirements"]], rows);
}

function showElimination(model, solved) {
  const rows = () => solved.chart.map(({ marks, decision }, group) => bodyRow(model.groups[group], [
    ...model.requirements.map((_, at) => cellOf(marks[at] || "", { class: "mark", style: marks[at] ? `background:${MARK_COLOURS[marks[at]]};color:#000` : null })),
    cellOf(decision),
  ]));
  const rule = (one) => `${one.low === null ? "" : `${one.low} <= `}${one.name}${one.high === null ? "" : ` <= ${one.high}`}${unitText(one.unit)}`;
  fillTable("live-elimination", [["alternative"], ...model.requirements.map((one) => [rule(one)]), ["decision"]], rows);
}

function showPugh(model, solved) {
  const found = solved.pugh;
  const rows = () => found.rows.map((row, at) => bodyRow(model.rows[row].name, [
    ...found.signs[at].map((sign) => cellOf(sign, { class: "mark", style: `background:${MARK_COLOURS[sign]};color:#000` })),
    ...["+", "-", "S", "?"].map((sign) => cellOf(`${found.signs[at].filter((one) => one === sign).length}`, { class: "number" })),
    cellOf(spanText(found.netLow[at], found.netHigh[at]), { class: "number" }),
  ], row === model.baseline));
  fillTable("live-pugh", [["alternative"], ...model.criteria.map((one) => [one.name]), ["+", true], ["-", true], ["S", true], ["?", true], ["net (option)", true]], rows);
}

function showPoints(model, solved) {
  const found = solved.overall;
  const rows = () => solved.ranked.map((at) => bodyRow(model.rows[solved.rows[at]].name, [
    ...found.points[at].map(([low, high, middle]) => cellOf(spanText(low, high, 2), { class: "number", style: shadeOf(middle, model.profile.min, model.profile.max) })),
    cellOf(plainNumber(found.total[at]), { class: "number" }),
    cellOf(found.share[at].toFixed(3), { class: "number" }),
    cellOf(rankText(found.ranks[at], found.range.best[at], found.range.worst[at]), { class: "number" }),
  ], solved.rows[at] === model.baseline));
  const heads = found.criteria.map((at) => [`${model.criteria[at].name} (${plainNumber(model.criteria[at].weight / found.weightSum)})`, true]);
  fillTable("live-kesselring", [["alternative"], ...heads, ["T", true], ["T/T_max", true], ["rank", true]], rows);
}

function drawStrength(model, solved, ratio) {
  const host = document.getElementById("live-strength");
  if (!host) return;
  host.hidden = !solved.economic;
  if (!solved.economic) return;
  const space = "http://www.w3.org/2000/svg", size = 320, edge = 38;
  const place = (value) => edge + value * (size - 2 * edge);
  const shape = (tag, attributes, text) => {
    const made = document.createElementNS(space, tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    if (text !== undefined) made.textContent = text;
    return made;
  };
  const axis = [0, 0.2, 0.4, 0.6, 0.8, 1].flatMap((value) => [
    shape("line", { x1: place(value), x2: place(value), y1: place(0), y2: place(1), class: "grid" }),
    shape("line", { y1: place(value), y2: place(value), x1: place(0), x2: place(1), class: "grid" }),
    shape("text", { x: place(value), y: size - edge + 14, "text-anchor": "middle" }, value),
    shape("text", { x: edge - 6, y: size - place(value) + 4, "text-anchor": "end" }, value),
  ]);
  const drawn = solved.rows.map((row, at) => [row, at]).filter(([row]) => row === model.baseline || hasRatio(model, row, ratio));
  const dots = drawn.map(([row, at]) => {
    const x = solved.technical.share[at], y = solved.economic.value[at], chosen = row === solved.winner;
    const dot = shape("circle", { cx: place(x), cy: size - place(y), r: chosen ? 7 : 3.5, class: chosen ? "chosen" : row === model.baseline ? "baseline" : "dot" });
    dot.append(shape("title", {}, `${model.rows[row].name}: technical ${x.toFixed(3)}, economic ${y.toFixed(3)}`));
    return dot;
  });
  host.querySelector("svg").replaceChildren(
    ...axis, shape("line", { x1: place(0), y1: place(1), x2: place(1), y2: place(0), class: "grid" }), ...dots,
    shape("text", { x: size / 2, y: size - 4, "text-anchor": "middle" }, "technical rating x"),
    shape("text", { x: 12, y: size / 2, "text-anchor": "middle", transform: `rotate(-90 12 ${size / 2})` }, "economic rating y"),
  );
}
