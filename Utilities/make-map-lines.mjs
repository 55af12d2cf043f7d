// Makes Data/map_lines.bin from the npm packages us-atlas 3.0.1 and world-atlas 2.0.2 (TopoJSON).
//
//   npm install --prefix /tmp/atlas us-atlas@3.0.1 world-atlas@2.0.2
//   node Utilities/make-map-lines.mjs /tmp/atlas/node_modules
//
// Documentation/Formats/map-lines.md describes the file that is written.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const KIND = { country: 0, state: 1, county: 2 };
const UNITS_PER_DEGREE = 1000; // about 100 m, below a pixel of a picture 300 km wide
const REACH_DEGREES = 8; // lines farther than this from every radar are left out
// Numeric ISO 3166 codes of the United States and those territories that us-atlas draws finer.
const UNITED_STATES = new Set(['840', '630', '316', '016', '580', '850']);
const LAKE_BORDER_DEGREES = 0.06; // the world's border counts where no line of us-atlas is this near

const repository = path.join(path.dirname(fileURLToPath(import.meta.url)), '..');

function readTopology(file) {
  const topology = JSON.parse(fs.readFileSync(file, 'utf8'));
  const { scale, translate } = topology.transform;
  const lines = topology.arcs.map((arc) => {
    let x = 0;
    let y = 0;
    return arc.map(([dx, dy]) => {
      x += dx;
      y += dy;
      return [x * scale[0] + translate[0], y * scale[1] + translate[1]];
    });
  });
  return { objects: topology.objects, lines };
}

// Arcs of a geometry; a negative number is an arc drawn backwards.
function arcsOf(geometry) {
  if (geometry.type === 'GeometryCollection') {
    return geometry.geometries.flatMap(arcsOf);
  }
  return (geometry.arcs ?? []).flat(Infinity).map((arc) => (arc < 0 ? ~arc : arc));
}

function unitedStates(folder) {
  const { objects, lines } = readTopology(path.join(folder, 'us-atlas/counties-10m.json'));
  const nation = new Set(arcsOf(objects.nation));
  const states = new Set(arcsOf(objects.states));
  return lines.map((points, arc) => ({
    kind: nation.has(arc) ? KIND.country : states.has(arc) ? KIND.state : KIND.county,
    points,
  }));
}

// True for points near a point of the lines. The points of us-atlas stand closer than the distance.
function nearness(lines) {
  const cells = new Set();
  const cell = (value) => Math.floor(value / LAKE_BORDER_DEGREES);
  for (const [x, y] of lines.flatMap((line) => line.points)) {
    for (let i = -1; i <= 1; i++) {
      for (let j = -1; j <= 1; j++) {
        cells.add(`${cell(x) + i},${cell(y) + j}`);
      }
    }
  }
  return ([x, y]) => cells.has(`${cell(x)},${cell(y)}`);
}

// Cuts a line into the runs of points for which `keep` holds.
function runs(points, keep) {
  const result = [[]];
  for (const point of points) {
    if (keep(point)) {
      result.at(-1).push(point);
    } else if (result.at(-1).length > 0) {
      result.push([]);
    }
  }
  return result.filter((run) => run.length > 1);
}

// Coasts and borders of the other countries, and the border of the United States where it runs
// through the Great Lakes: us-atlas follows the shore there.
function otherCountries(folder, domestic) {
  const { objects, lines } = readTopology(path.join(folder, 'world-atlas/countries-50m.json'));
  const owners = lines.map(() => []);
  for (const country of objects.countries.geometries) {
    for (const arc of arcsOf(country)) {
      owners[arc].push(String(country.id));
    }
  }
  const drawn = nearness(domestic.filter((line) => line.kind === KIND.country));
  return lines.flatMap((points, arc) => {
    const ofUs = owners[arc].filter((id) => UNITED_STATES.has(id)).length;
    if (ofUs === owners[arc].length) {
      return [];
    }
    const parts = ofUs > 0 ? runs(points, (point) => !drawn(point)) : [points];
    return parts.map((part) => ({ kind: KIND.country, points: part }));
  });
}

function radarPositions() {
  const rows = fs.readFileSync(path.join(repository, 'Data/radar_sites.csv'), 'utf8').trim().split('\n');
  const columns = rows[0].split(',');
  const longitude = columns.indexOf('longitude_deg');
  const latitude = columns.indexOf('latitude_deg');
  return rows.slice(1).map((row) => {
    const fields = row.split(',');
    return [Number(fields[longitude]), Number(fields[latitude])];
  });
}

function quantise(points) {
  const integers = points.map((point) => point.map((value) => Math.round(value * UNITS_PER_DEGREE)));
  return integers.filter(
    ([x, y], i) => i === 0 || x !== integers[i - 1][0] || y !== integers[i - 1][1]);
}

function pushVarint(bytes, value) {
  while (value >= 0x80) {
    bytes.push((value & 0x7f) | 0x80);
    value >>>= 7;
  }
  bytes.push(value);
}

function encode(lines) {
  const bytes = [...Buffer.from('NXMAP1\n')];
  pushVarint(bytes, UNITS_PER_DEGREE);
  pushVarint(bytes, lines.length);
  for (const { kind, points } of lines) {
    bytes.push(kind);
    pushVarint(bytes, points.length);
    let last = [0, 0];
    for (const point of points) {
      for (const axis of [0, 1]) {
        const step = point[axis] - last[axis];
        pushVarint(bytes, step < 0 ? -2 * step - 1 : 2 * step);
      }
      last = point;
    }
  }
  return Buffer.from(bytes);
}

const folder = process.argv[2];
if (folder === undefined) {
  console.error('usage: make-map-lines.mjs FOLDER-OF-NODE-MODULES');
  process.exit(2);
}
const domestic = unitedStates(folder);
const radars = radarPositions();
const withinReach = ([x, y]) =>
  radars.some(([a, b]) => Math.abs(x - a) < REACH_DEGREES && Math.abs(y - b) < REACH_DEGREES);
const lines = [...domestic, ...otherCountries(folder, domestic)]
  .filter((line) => line.points.some(withinReach))
  .map(({ kind, points }) => ({ kind, points: quantise(points) }))
  .filter((line) => line.points.length > 1)
  .sort((a, b) => a.kind - b.kind);
const file = path.join(repository, 'Data/map_lines.bin');
const bytes = encode(lines);
fs.writeFileSync(file, bytes);
const points = lines.reduce((sum, line) => sum + line.points.length, 0);
console.log(`${file}: ${lines.length} lines, ${points} points, ${bytes.length} bytes`);
