// Makes Data/elevations.bin from ETOPO5 (NOAA) in the Debian package ferret-datasets 7.6.0-5, and Data/map_towns.csv from
// Natural Earth's populated places in the Debian package libmagics++-data 4.13.0-1.
//
//   cd /tmp && apt-get download ferret-datasets libmagics++-data
//   for package in ferret-datasets*.deb libmagics++-data*.deb; do dpkg-deb -x $package /tmp/relief; done
//   node Utilities/make-relief.mjs /tmp/relief
//
// Documentation/Formats/elevations.md describes the file of elevations.
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import { pushSigned, pushUnsigned, withinReach, write } from './map-files.mjs';

const SAMPLES_PER_DEGREE = 12;
const COLUMNS = 360 * SAMPLES_PER_DEGREE; // from 0° eastwards
const ROWS = 180 * SAMPLES_PER_DEGREE + 1; // from 90° S northwards
const METRES_PER_UNIT = 5;
const TILE_DEGREES = 4;

// The only array of the file with more than one dimension is its last one: 32-bit numbers, the highest byte first.
function readElevations(file) {
  const bytes = fs.readFileSync(file);
  const size = 4 * ROWS * COLUMNS;
  if (bytes.toString('latin1', 0, 3) !== 'CDF' || bytes.length < size) {
    throw new Error(`${file} is not the file etopo5.cdf`);
  }
  const start = bytes.length - size;
  return (column, row) => bytes.readFloatBE(start + 4 * (row * COLUMNS + column));
}

// Heights of land; the sea has 0. Samples are counted from the place at 0° E, 0° N.
function unitsAt(elevation, x, y) {
  const row = Math.min(ROWS - 1, y + 90 * SAMPLES_PER_DEGREE);
  const metres = elevation((x + COLUMNS) % COLUMNS, row);
  return Math.round(Math.max(0, metres) / METRES_PER_UNIT);
}

function isWanted(west, south) {
  for (let x = west; x <= west + TILE_DEGREES; x++) {
    for (let y = south; y <= south + TILE_DEGREES; y++) {
      if (withinReach([x, y])) {
        return true;
      }
    }
  }
  return false;
}

// Each sample as its step from what those to the west, to the south and between them let expect.
function pushTile(bytes, elevation, west, south) {
  const side = TILE_DEGREES * SAMPLES_PER_DEGREE;
  const at = (i, j) => (i < 0 || j < 0 ? 0
    : unitsAt(elevation, west * SAMPLES_PER_DEGREE + i, south * SAMPLES_PER_DEGREE + j));
  for (let j = 0; j < side; j++) {
    for (let i = 0; i < side; i++) {
      pushSigned(bytes, at(i, j) - at(i - 1, j) - at(i, j - 1) + at(i - 1, j - 1));
    }
  }
}

function writeElevations(elevation) {
  const tiles = [];
  for (let south = -88; south < 88; south += TILE_DEGREES) {
    for (let west = -180; west < 180; west += TILE_DEGREES) {
      if (isWanted(west, south)) {
        tiles.push([west, south]);
      }
    }
  }
  const head = [...Buffer.from('NXELEV1\n')];
  [SAMPLES_PER_DEGREE, METRES_PER_UNIT, TILE_DEGREES, tiles.length].forEach((value) => pushUnsigned(head, value));
  const samples = [];
  for (const [west, south] of tiles) {
    pushSigned(head, west);
    pushSigned(head, south);
    pushTile(samples, elevation, west, south);
  }
  pushUnsigned(head, samples.length);
  const stream = zlib.deflateSync(Buffer.from(samples), { level: 9 });
  write('elevations.bin', Buffer.concat([Buffer.from(head), stream]), `${tiles.length} tiles`);
}

// The rows of a dBASE file as objects of texts.
function readDbf(file) {
  const bytes = fs.readFileSync(file);
  const [count, first, length] = [bytes.readUInt32LE(4), bytes.readUInt16LE(8), bytes.readUInt16LE(10)];
  const fields = [];
  for (let field = 32, offset = 1; bytes[field] !== 0x0d; field += 32) {
    const name = bytes.toString('latin1', field, field + 11).split('\0')[0];
    fields.push({ name, offset, length: bytes[field + 16] });
    offset += bytes[field + 16];
  }
  return Array.from({ length: count }, (_, row) => Object.fromEntries(fields.map((field) => {
    const start = first + row * length + field.offset;
    return [field.name, bytes.toString('latin1', start, start + field.length).replace(/\0/g, '').trim()];
  })));
}

function writeTowns(places) {
  const rows = places
    .map((place) => ({ name: place.nameascii.normalize('NFD').replace(/\p{M}/gu, ''), population: Number(place.pop_max),
      point: [Number(place.longitude), Number(place.latitude)] }))
    .filter(({ name, population, point }) => name !== '' && !name.includes(',') && population > 0 && withinReach(point))
    .sort((a, b) => b.population - a.population)
    .map(({ name, point }) => [name, ...point.map((value) => value.toFixed(2))].join(','));
  write('map_towns.csv', `name,longitude_deg,latitude_deg\n${rows.join('\n')}\n`, `${rows.length} towns`);
}

const folder = process.argv[2];
if (folder === undefined) {
  console.error('usage: make-relief.mjs FOLDER-OF-DEBIAN-PACKAGES');
  process.exit(2);
}
writeElevations(readElevations(path.join(folder, 'usr/share/ferret-vis/data/etopo5.cdf')));
writeTowns(readDbf(path.join(folder, 'usr/share/magics/10m/ne_10m_populated_places_simple.dbf')));
