// SPDX-License-Identifier: BSD-3-Clause
// What the picture says at its edges: the time, what is shown, the radars, what the heights are, SYNTHETIC, and the colour
// bar. Places and sizes are those of Source/Scene/Captions and Source/Scene/Scales/ColourBar.cxx.

const warningWord = 'SYNTHETIC';
const mostNamed = 16; // radars
const bar = { width: 0.02, bottom: 0.1, top: 0.88 }; // fractions of the picture

// "2006-03-12 18:30:00 UTC" of milliseconds since 1970.
export function timeText(milliseconds) {
  return `${new Date(milliseconds).toISOString().slice(0, 19).replace('T', ' ')} UTC`;
}

// The radars as words, as NameSites of Source/Scene/Captions/Captions.cxx has them.
export const namesOf = (radars) => (radars.length > mostNamed ? [`${radars.length} radars`] : radars);

function wrap(words, width, style, letters) {
  const lines = [];
  for (const word of words) {
    const longer = lines.length > 0 ? `${lines[lines.length - 1]} ${word}` : word;
    if (lines.length > 0 && letters.sizeOf(longer, style)[0] <= width) {
      lines[lines.length - 1] = longer;
    } else {
      lines.push(word);
    }
  }
  return lines.join('\n');
}

export function heightNote(stretch) {
  return stretch === 1
    ? 'Height above mean sea level, to scale'
    : `Height above mean sea level, stretched ${stretch} times`;
}

// Widths are rounded up to an eighth of the picture, so that a letter more does not move the scene.
function takenBy(box, side, width) {
  const eighth = width / 8;
  return side === 'below'
    ? box
    : { ...box, right: box.left + eighth * Math.ceil((box.right - box.left) / eighth) };
}

export class Captions {
  // `texts`: time, title, method, sites, note, synthetic. `right`: where the colour bar begins.
  constructor(texts, width, height, right, size, theme, letters) {
    Object.assign(this, { letters, width });
    this.items = [];
    const style = (factor, colour, bold) => ({ size: Math.floor(size * factor), colour, rim: theme.rim, bold });
    const [title, note, warning] = [
      style(1.5, theme.title, true), style(1, theme.note, false), style(2.5, theme.warning, true)];
    const left = Math.max(0.75 * size, 0.02 * width);
    const top = height - 0.75 * size;
    const time = this.add(texts.time, title, [left, top], 'below right');
    const half = 0.5 * letters.sizeOf(warningWord, warning)[0];
    const middle = Math.max(0.5 * width, time.right + left + half);
    const above = texts.synthetic && middle + half < right;
    const room = (above ? middle - half : right) - 2 * left;
    const what = `${texts.title}${texts.method ? `, method ${texts.method}` : ''}`;
    const lines = [wrap(what.split(' '), room, note, letters), wrap(texts.sites, room, note, letters)].join('\n');
    const below = this.add(lines, note, [left, time.bottom - 0.4 * size], 'below right');
    this.add(wrap(texts.note.split(' '), right - 2 * left, note, letters), note, [left, 0.75 * size], 'above right');
    if (above) {
      this.add(warningWord, warning, [middle, top], 'below');
    } else if (texts.synthetic) {
      this.add(warningWord, warning, [left, below.bottom - 0.3 * size], 'below right');
    }
  }

  add(text, style, point, side) {
    const box = boxOf(this.letters, text, style, point, side);
    this.items.push({ text, style, point, side, taken: takenBy(box, side, this.width) });
    return box;
  }

  // The rectangles that the scene leaves free.
  taken() {
    return this.items.map((item) => item.taken);
  }

  draw() {
    for (const { text, style, point, side } of this.items) {
      this.letters.draw(text, style, point, side);
    }
  }
}

function boxOf(letters, text, style, [x, y], side) {
  const [width, height] = letters.sizeOf(text, style);
  const left = side === 'below' ? x - 0.5 * width : x;
  const bottom = side.startsWith('above') ? y : y - height;
  return { left, bottom, right: left + width, top: bottom + height };
}

const numberText = (value, decimals) => (decimals < 0 ? String(Number(value.toPrecision(6))) : value.toFixed(decimals));

// Boxes of one height with the values at which they begin, as many as there is room for.
function boxLayout(bins, { decimals }, most) {
  const every = Math.max(1, Math.ceil(bins.length / most));
  const edges = [...bins.keys(), bins.length].map((edge) => edge / bins.length);
  const labels = bins.map(({ from }, bin) => ({ place: edges[bin], text: numberText(from, decimals) }));
  return { edges, labels: labels.filter((_, bin) => bin % every === 0) };
}

// From one label to the next: 1, 2, 5, 10, … times the step of the labels, or else times a power of ten.
function labelStep(step, least) {
  for (let decade = step > 0 ? step : 10 ** Math.floor(Math.log10(least)); ; decade *= 10) {
    const factor = [1, 2, 5].find((each) => each * decade >= least);
    if (factor) {
      return factor * decade;
    }
  }
}

// Bins as high as they are wide in values, with round values.
function valueLayout(bins, { step, decimals }, most) {
  const last = bins[bins.length - 1];
  const [lowest, highest] = [bins[0].from, last.to ?? 2 * last.from - bins[bins.length - 2].from];
  const share = (value) => (value - lowest) / (highest - lowest);
  const every = labelStep(step, (highest - lowest) / most);
  const labels = [];
  for (let i = Math.ceil(lowest / every - 1e-9); i <= highest / every + 1e-9; i += 1) {
    labels.push({ place: share(i * every), text: numberText(i * every + 0, decimals) });
  }
  return { edges: [...bins.map(({ from }) => share(from)), 1], labels };
}

// The colours of a preset, with their values and the unit above.
export class ColourBar {
  // `preset`: bins ({ from, colour, and of a ramp to and upper }, ascending) and labels.
  constructor({ bins, labels }, width, height, style, letters) {
    Object.assign(this, { bins, unit: labels.unit, height, style, letters });
    const most = Math.max(1, ((bar.top - bar.bottom) * height) / (1.15 * style.size));
    const ramps = bins.length > 1 && bins.some(({ upper }) => upper);
    this.layout = ramps ? valueLayout(bins, labels, 0.6 * most) : boxLayout(bins, labels, most);
    const gap = 0.5 * style.size;
    const longest = Math.max(...this.layout.labels.map(({ text }) => letters.sizeOf(text, style)[0]));
    this.right = width - longest - 2 * gap;
    this.barLeft = this.right - bar.width * width;
    this.left = Math.min(this.barLeft, width - gap - letters.sizeOf(this.unit, style)[0]);
  }

  heightOf(share) {
    return this.height * (bar.bottom + (bar.top - bar.bottom) * share);
  }

  draw(edge) {
    const { letters, style, bins, layout } = this;
    const box = (low, high) => ({ left: this.barLeft, right: this.right, bottom: this.heightOf(low), top: this.heightOf(high) });
    bins.forEach(({ colour, upper }, bin) =>
      letters.rectangle(box(layout.edges[bin], layout.edges[bin + 1]), colour, upper));
    letters.frame(box(0, 1), edge);
    for (const { place, text } of layout.labels) {
      letters.draw(text, style, [this.right + 0.5 * style.size, this.heightOf(place)], 'right');
    }
    letters.draw(this.unit, style, [this.left, this.height * bar.top + 0.9 * style.size], 'right');
  }
}
