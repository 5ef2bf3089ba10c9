"use strict";
// Curves with up to some million samples: lowest and highest sample of blocks of several sizes, so that no view loses a peak.

const FIRST_BLOCK = 4, NEXT_BLOCK = 2; // samples of the smallest block; blocks of each level in one of the next
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

// Blocks of `size` blocks of a level: the samples with the lowest and the highest value, by their index.
function merged(values, level, size) {
  const count = Math.ceil(level.lowAt.length / size);
  const lowAt = new Uint32Array(count), highAt = new Uint32Array(count);
  for (let block = 0, at = 0; block < count; block += 1) {
    const end = Math.min(at + size, level.lowAt.length);
    let low = level.lowAt[at], high = level.highAt[at];
    for (at += 1; at < end; at += 1) {
      if (values[level.lowAt[at]] < values[low]) low = level.lowAt[at];
      if (values[level.highAt[at]] > values[high]) high = level.highAt[at];
    }
    lowAt[block] = low;
    highAt[block] = high;
  }
  return { block: level.block * size, lowAt, highAt };
}

function makePyramid(curve) {
  const all = Uint32Array.from(curve.values, (_, at) => at), levels = [{ block: 1, lowAt: all, highAt: all }];
  let size = FIRST_BLOCK;
  while (levels[levels.length - 1].lowAt.length > 2 * size) {
    levels.push(merged(curve.values, levels[levels.length - 1], size));
    size = NEXT_BLOCK;
  }
  return { curve, levels };
}

// The part from x `from` to x `to` as at most about 3 * columns points: of each block its lowest and its highest sample.
function pyramidView(pyramid, from, to, columns) {
  const { start, step, values } = pyramid.curve, x = [], y = [];
  const first = Math.max(Math.floor((from - start) / step) - 1, 0);
  const last = Math.min(Math.ceil((to - start) / step) + 1, values.length - 1);
  if (last < first) return { x, y };
  const fits = (one) => (last - first + 1) / one.block <= (one.block === 1 ? DRAWN_AS_IS : 1) * columns;
  const level = pyramid.levels.find(fits) || pyramid.levels[pyramid.levels.length - 1];
  const add = (at) => { x.push(start + at * step); y.push(values[at]); };
  for (let block = Math.floor(first / level.block); block <= Math.floor(last / level.block); block += 1) {
    const low = level.lowAt[block], high = level.highAt[block];
    add(Math.min(low, high));
    if (low !== high) add(Math.max(low, high));
  }
  return { x, y };
}
