"use strict";
// Curves with up to some million samples: lowest and highest sample of blocks of several sizes, so that no view loses a peak.

const FIRST_BLOCK = 4, NEXT_BLOCK = 2; // samples of the smallest block; blocks of each level in one of the next
const CROWDED = 40; // strokes over the whole height on a page's width: one in some 30 pixels
const DRAWN_AS_IS = 3; // samples a column of pixels up to which the samples themselves are drawn

function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (one) => one.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
}

async function unpackCurve(curve) {
  const planes = new Uint8Array(await unpacked(curve.packed).arrayBuffer());
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

// Blocks of `size` samples, or of `size` blocks of a level: the samples with the lowest and the highest value, by index.
function merged(values, level, size) {
  const known = level ? level.lowAt.length : values.length, count = Math.ceil(known / size);
  const lowAt = new Uint32Array(count), highAt = new Uint32Array(count);
  for (let block = 0, at = 0; block < count; block += 1) {
    const end = Math.min(at + size, known);
    let low = level ? level.lowAt[at] : at, high = level ? level.highAt[at] : at;
    let least = values[low], most = values[high];
    for (at += 1; at < end; at += 1) {
      const lower = level ? level.lowAt[at] : at, higher = level ? level.highAt[at] : at;
      if (values[lower] < least) { low = lower; least = values[lower]; }
      if (values[higher] > most) { high = higher; most = values[higher]; }
    }
    lowAt[block] = low;
    highAt[block] = high;
  }
  return { block: (level ? level.block : 1) * size, lowAt, highAt };
}

function makePyramid(curve) {
  const levels = [];
  let blocks = curve.values.length, size = FIRST_BLOCK;
  while (blocks > 2 * size) {
    levels.push(merged(curve.values, levels[levels.length - 1], size));
    blocks = levels[levels.length - 1].lowAt.length;
    size = NEXT_BLOCK;
  }
  return { curve, levels };
}

// The part from x `from` to x `to` as at most 1.5 points a pixel of `columns` pairs of pixels: the samples themselves, or of
// each block its lowest and its highest sample. `crowded`: up and down so often that strokes touch.
function pyramidView(pyramid, from, to, columns) {
  const { start, step, values } = pyramid.curve;
  const first = Math.max(Math.floor((from - start) / step) - 1, 0);
  const last = Math.min(Math.ceil((to - start) / step) + 1, values.length - 1), samples = last - first + 1;
  if (samples < 1) return { x: [], y: [], crowded: false };
  const level = pyramid.levels.find((one) => samples / one.block <= columns) || pyramid.levels[pyramid.levels.length - 1];
  if (samples <= DRAWN_AS_IS * columns || !level) {
    const x = new Float64Array(samples).map((_, at) => start + (first + at) * step);
    const y = values.subarray(first, last + 1);
    return { x, y, crowded: strokes(y) > CROWDED };
  }
  const begin = Math.floor(first / level.block), end = Math.floor(last / level.block);
  const x = new Float64Array(2 * (end - begin + 1)), y = new Float64Array(x.length);
  let count = 0;
  const add = (at) => { x[count] = start + at * step; y[count] = values[at]; count += 1; };
  for (let block = begin; block <= end; block += 1) {
    const low = level.lowAt[block], high = level.highAt[block];
    add(Math.min(low, high));
    if (low !== high) add(Math.max(low, high));
  }
  const shown = y.subarray(0, count);
  return { x: x.subarray(0, count), y: shown, crowded: strokes(shown) > CROWDED };
}

// How often a curve runs over its whole height.
function strokes(y) {
  let way = 0, low = y[0], high = y[0];
  for (let at = 1; at < y.length; at += 1) {
    way += Math.abs(y[at] - y[at - 1]);
    if (y[at] < low) low = y[at];
    if (y[at] > high) high = y[at];
  }
  return high > low ? way / (high - low) : 0;
}
