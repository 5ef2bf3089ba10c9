"use strict";
// Elimination, Pugh, Kesselring and S-diagram from numbers: the same rules as torquerig.decide, to the last digits.

const TIE = 1e-9; // as torquerig.decide.ranks.TIE
const ROUNDING = 1e-12; // [1] as torquerig.decide.pugh

function pointsAt(knots, value) {
  if (value <= knots[0][0]) return knots[0][1];
  for (let at = 1; at < knots.length; at += 1) {
    const [left, low] = knots[at - 1], [right, high] = knots[at];
    if (value <= right) return low + (high - low) * (value - left) / (right - left);
  }
  return knots[knots.length - 1][1];
}

function pointsOfCell(cell, criterion, profile) {
  if (cell.points !== null) return [cell.points, cell.points, cell.points];
  if (cell.low === null || criterion.knots === null) return [profile.min, profile.max, (profile.min + profile.max) / 2];
  const inside = criterion.knots.filter(([value]) => cell.low < value && value < cell.high).map(([, points]) => points);
  const all = [pointsAt(criterion.knots, cell.low), pointsAt(criterion.knots, cell.high), ...inside];
  const low = Math.min(...all), high = Math.max(...all);
  return [low, high, cell.value === null ? (low + high) / 2 : pointsAt(criterion.knots, cell.value)];
}

function competitionRanks(scores) {
  return scores.map((score) => 1 + scores.filter((other) => other > score + TIE).length);
}

function rankRange(low, high) {
  const best = low.map((_, at) => 1 + low.filter((one) => one > high[at] + TIE).length);
  const worst = low.map((_, at) => 1 + high.filter((one, other) => other !== at && one > low[at] + TIE).length);
  return { best, worst };
}

function eliminated(model) {
  return model.limits.map((cells) => {
    const marks = [];
    for (const [at, limit] of model.requirements.entries()) {
      const mark = markOf(cells[at], limit);
      marks.push(mark);
      if (mark === "-") break;
    }
    const decision = marks.includes("-") ? "eliminate" : marks.includes("!") ? "revise" : marks.includes("?") ? "open" : "pursue";
    return { marks, decision };
  });
}

function markOf(cell, limit) {
  if (limit.low === null && limit.high === null) return "+";
  if (cell.low === null) return "?";
  if ((limit.low === null || cell.low >= limit.low) && (limit.high === null || cell.high <= limit.high)) return "+";
  const fails = (limit.low !== null && cell.high < limit.low) || (limit.high !== null && cell.low > limit.high);
  return fails ? (limit.inQuestion ? "!" : "-") : "?";
}

// Weighted points of the rows, over criteria that `counts` admits; null where none has a weight.
function kesselring(model, rows, counts) {
  const used = model.criteria.map((one, at) => ({ ...one, at })).filter((one) => one.weight > 0 && counts(one));
  if (!used.length) return null;
  const points = rows.map((row) => used.map((one) => pointsOfCell(model.cells[row][one.at], one, model.profile)));
  const total = (which) => points.map((cells) => cells.reduce((sum, cell, at) => sum + cell[which] * used[at].weight, 0));
  const sum = used.reduce((all, one) => all + one.weight, 0), ideal = model.profile.max * sum;
  const low = total(0), high = total(1), middle = total(2);
  return { criteria: used.map((one) => one.at), points, weightSum: sum, ideal, low, high, total: middle,
    share: middle.map((one) => one / ideal), ranks: competitionRanks(middle), range: rankRange(low, high) };
}

function meritOf(cell, criterion) {
  if (cell.low === null) return [NaN, NaN];
  if (criterion.better === "more") return [cell.low, cell.high];
  if (criterion.better === "less" || criterion.band === null) return [-cell.high, -cell.low];
  const [from, to] = criterion.band;
  const distance = [cell.low, cell.high].map((end) => -Math.max(0, from - end, end - to));
  const touches = cell.low <= to && cell.high >= from;
  return [Math.min(...distance), touches ? 0 : Math.max(...distance)];
}

function signOf(ours, baseline, criterion, unknown) {
  const difference = ours - baseline, size = Math.max(Math.abs(ours), Math.abs(baseline));
  if (Number.isNaN(difference)) return unknown;
  const band = Math.max(criterion.absolute, criterion.relative * size) + ROUNDING * size;
  return difference > band ? 1 : difference < -band ? -1 : 0;
}

function pugh(model, rows) {
  const low = [], high = [];
  for (const row of rows) {
    const ends = model.criteria.map((criterion, at) => {
      if (row === model.baseline) return [0, 0];
      const [poor, good] = meritOf(model.cells[row][at], criterion);
      const [worst, best] = meritOf(model.cells[model.baseline][at], criterion);
      return [signOf(poor, best, criterion, -1), signOf(good, worst, criterion, 1)];
    });
    low.push(ends.map((end) => end[0]));
    high.push(ends.map((end) => end[1]));
  }
  const signs = low.map((ends, row) => ends.map((end, at) => (end === high[row][at] ? "-S+"[end + 1] : "?")));
  const net = (ends) => ends.map((row) => row.reduce((sum, one) => sum + one, 0));
  const netLow = net(low), netHigh = net(high);
  return { rows, signs, netLow, netHigh, range: rankRange(netLow, netHigh) };
}

function economicOf(model, rows) {
  if (model.cost === null) {
    const found = kesselring(model, rows, (one) => one.kind === "economic");
    return found && { value: found.share, low: found.low.map((one) => one / found.ideal), high: found.high.map((one) => one / found.ideal) };
  }
  const rated = (cost) => (cost <= model.cost.ideal ? 1 : model.cost.ideal / cost);
  const cells = rows.map((row) => model.cost.cells[row]);
  const low = cells.map((cell) => (cell.low === null ? 0 : rated(cell.high)));
  const high = cells.map((cell) => (cell.low === null ? 1 : rated(cell.low)));
  const value = cells.map((cell, at) => (cell.low === null ? 0.5 : cell.value === null ? (low[at] + high[at]) / 2 : rated(cell.value)));
  return { value, low, high };
}

function solveMatrices(model) {
  const chart = eliminated(model), all = model.rows.map((_, row) => row);
  const kept = (row) => chart[model.rows[row].group].decision !== "eliminate";
  const present = model.rows[model.baseline].group;
  let rows = all.filter((row) => kept(row) || (model.keepsBaseline && model.rows[row].group === present));
  if (!rows.length) rows = all;
  const overall = kesselring(model, rows, () => true);
  const technical = kesselring(model, rows, (one) => one.kind === "technical");
  const ranked = overall === null ? [] : rows.map((_, at) => at).sort((a, b) => overall.total[b] - overall.total[a] || a - b);
  const winner = ranked.find((at) => kept(rows[at]));
  return { chart, rows, overall, technical, economic: technical && economicOf(model, rows), ranked,
    winner: winner === undefined ? null : rows[winner], pugh: pugh(model, model.pughOfAll ? all : rows) };
}
