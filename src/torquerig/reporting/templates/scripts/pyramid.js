"use strict";
// Curves with up to some million samples: minimum and maximum of blocks at several sizes, so that no view loses a peak.

const FIRST_BLOCK = 4, NEXT_BLOCK = 4; // samples of the smallest block; blocks of each level in one of the next
const DRAWN_AS_IS = 3; // samples a column of pixels up to which the samples themselves are drawn

async function unpackCurve(curve) {
  const bytes = Uint8Array.from(atob(curve.packed), (one) => one.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  const planes = new Uint8Array(await new Response(stream).arrayBuffer());
  const values = new Float64Array(curve.samples), count = curve.samples;
  let code = 0;
  for (let at = 0; at < count; at += 1) { // differences of either sign, low bytes first: see packed_curve.py
    const signless = planes[at] | (planes[count + at] << 8);
    code = (code + ((signless >>> 1) ^ -(signless & 1))) & 0xffff;
    const value = curve.low + code * curve.size;
    values[at] = curve.logarithmic ? 10 ** value : value;
  }
  return { values, start: curve.start, step: curve.step };
}

function merged(low, high, size) {
  const count = Math.ceil(low.length / size);
  const least = new Float64Array(count), most = new Float64Array(count);
  for (let block = 0, at = 0; block < count; block += 1) {
    const end = Math.min(at + size, low.length);
    let minimum = low[at], maximum = high[at];
    for (at += 1; at < end; at += 1) {
      if (low[at] < minimum) minimum = low[at];
      if (high[at] > maximum) maximum = high[at];
    }
    least[block] = minimum;
    most[block] = maximum;
  }
  return { low: least, high: most };
}

function makePyramid(curve) {
  const levels = [{ block: 1, low: curve.values, high: curve.values }];
  let size = FIRST_BLOCK;
  while (levels[levels.length - 1].low.length > 2 * size) {
    const last = levels[levels.length - 1];
    levels.push({ block: last.block * size, ...merged(last.low, last.high, size) });
    size = NEXT_BLOCK;
  }
  return { curve, levels };
}

// The part from x `from` to x `to` as at most about 3 * columns points: each block gives its minimum and maximum.
function pyramidView(pyramid, from, to, columns) {
  const { start, step, values } = pyramid.curve;
  const first = Math.max(Math.floor((from - start) / step) - 1, 0);
  const last = Math.min(Math.ceil((to - start) / step) + 1, values.length - 1);
  if (last < first) return { x: [], y: [] };
  const fits = (one) => (last - first + 1) / one.block <= (one.block === 1 ? DRAWN_AS_IS : 1) * columns;
  const level = pyramid.levels.find(fits) || pyramid.levels[pyramid.levels.length - 1];
  const x = [], y = [];
  if (level.block === 1) {
    for (let at = first; at <= last; at += 1) { x.push(start + at * step); y.push(values[at]); }
    return { x, y };
  }
  for (let block = Math.floor(first / level.block); block <= Math.floor(last / level.block); block += 1) {
    const end = Math.min((block + 1) * level.block, values.length) - 1;
    const middle = start + step * (block * level.block + end) / 2;
    x.push(middle, middle);
    y.push(level.low[block], level.high[block]);
  }
  return { x, y };
}
