// SPDX-License-Identifier: BSD-3-Clause
// Feeds damaged files to the functions by which a page reads them (Source/Web/Scripts): volume files and the index of a
// series, which a page takes from its server, and the packed columns in a page itself. Node runs the scripts as they are.
// The same inputs come in every run.
//
//   node FuzzPage.mjs COPIES SEED [SECONDS]   COPIES damaged copies of each input; with SECONDS again and again until then
import { strict as assert } from 'node:assert';
import { cpSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { deflateSync } from 'node:zlib';

const size = [5, 4, 3];
const voxels = size[0] * size[1] * size[2];
const slowest = 1000; // milliseconds for one input
const mostBytes = 64e6; // that the memory may grow by for one input

// The scripts are modules without a package around them, which Node wants.
async function loadScripts() {
  const folder = mkdtempSync(join(tmpdir(), 'nexrad-page-'));
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  const scripts = join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'Source', 'Web', 'Scripts');
  cpSync(scripts, folder, { recursive: true });
  writeFileSync(join(folder, 'package.json'), '{"type": "module"}');
  const load = (name) => import(pathToFileURL(join(folder, name)).href);
  return { ...await load('frame.js'), ...await load('series.js') };
}

function fileOf(header, payload) {
  const text = Buffer.from(JSON.stringify(header));
  const start = Buffer.alloc(8);
  start.write('NXV1');
  start.writeUInt32LE(text.length, 4);
  return Buffer.concat([start, text, payload]);
}

function volumeFile(type, encoding, bytes) {
  const payload = encoding === 'rle' ? bytes : deflateSync(bytes);
  const array = { name: 'REF', type, unit: 'dBZ', offset: -33, scale: 0.5, fill: -33, encoding, length: payload.length };
  return fileOf({ dimensions: size, arrays: [array] }, payload);
}

function makeVolumeFiles() {
  const codes = Buffer.from(Array.from({ length: voxels }, (_, i) => (i % 3 === 0 ? 40 + i : i % 3 - 1)));
  const words = Buffer.concat([codes, Buffer.alloc(voxels, 1)]);
  const floats = Buffer.from(Float32Array.from(codes, (code) => code / 2).buffer);
  const runs = Buffer.concat([Buffer.from(Array(20).fill(128 + 35)), Buffer.from([0, 40, 0, 0, 0])]);
  return [volumeFile('uint8', 'deflate', codes), volumeFile('uint16', 'deflate', words),
    volumeFile('float32', 'deflate', floats), volumeFile('uint7', 'rle', runs)];
}

// Numbers in order that depend on nothing but the seed.
function makeRandom(seed) {
  let state = seed >>> 0 || 1;
  return (limit) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return limit < 1 ? 0 : Math.floor((state / 2 ** 32) * limit);
  };
}

const numbers = ['0', '-1', '1e308', '1e-320', '9007199254740993', '4294967296', '0.5', 'null', '""', '[]', '{}'];

function damage(bytes, random) {
  const place = random(bytes.length);
  const end = place + random(Math.min(bytes.length - place, 300));
  const kinds = [
    () => Buffer.concat([bytes.subarray(0, place), bytes.subarray(end)]),
    () => Buffer.concat([bytes.subarray(0, end), bytes.subarray(place)]),
    () => bytes.subarray(0, place),
    () => Buffer.from(bytes).fill(random(256), place, end),
    () => {
      const text = bytes.toString('latin1');
      const found = text.slice(place).match(/\d+/);
      const from = found === null ? text.length : place + found.index;
      const to = found === null ? text.length : from + found[0].length;
      return Buffer.from(text.slice(0, from) + numbers[random(numbers.length)] + text.slice(to), 'latin1');
    },
    () => {
      const copy = Buffer.from(bytes);
      for (let i = random(8); i >= 0 && copy.length > 0; i--) {
        copy[random(copy.length)] ^= 1 << random(8);
      }
      return copy;
    },
  ];
  return kinds[random(kinds.length)]();
}

// The length in the header follows a header that became longer or shorter, so that what is behind it is reached.
function withHeaderLength(bytes) {
  const end = bytes.lastIndexOf(Buffer.from('}]}'));
  if (end < 8) {
    return bytes;
  }
  const copy = Buffer.from(bytes);
  copy.writeUInt32LE(end + 3 - 8, 4);
  return copy;
}

async function readVolume({ FolderSeries }, bytes) {
  const scene = { series: 'day.nxv.series', size, array: 'REF', scale: { first: -33, step: 0.5 }, masked: true };
  const series = new FolderSeries(scene, async () => new Response(bytes));
  const frame = await series.read('volume.nxv');
  assert.equal(frame.bytes.length, voxels, 'each voxel has a byte');
}

async function readIndex({ FolderSeries }, bytes) {
  const series = new FolderSeries({ series: 'day.nxv.series' }, async () => new Response(bytes));
  await series.refresh();
  assert.equal(series.names.length, series.times.length, 'each name has a time');
  assert(series.times.every(Number.isFinite), 'times are numbers');
  assert(series.names.every((name) => typeof name === 'string'), 'names are texts');
}

function unpack({ unpackColumns }, bytes) {
  const ends = bytes.subarray(0, bytes.length >> 1);
  const unpacked = unpackColumns(size, ends, bytes.subarray(bytes.length >> 1), Uint8Array.from({ length: 256 }, (_, i) => i));
  assert.equal(unpacked.length, voxels, 'each voxel has a byte');
}

const index = Buffer.from('{"file-series-version":"1.0","files":[{"name":"a.nxv","time":1142186400.0},' +
  '{"name":"b/c.nxv","time":1142186700.25}]}');
// Echo in all layers of each column: ends as differences to those of the column before, then codes.
const columns = Buffer.from([2, 0, 3, ...Array(19).fill([2, 0, 0]).flat(), ...Array(voxels).fill(1)]);

// Damage is an error that can be shown; anything else is a finding.
async function run(read, scripts, bytes) {
  const begin = performance.now();
  const before = process.memoryUsage().arrayBuffers;
  try {
    await read(scripts, bytes);
  } catch (problem) {
    if (!(problem instanceof Error) || problem instanceof assert.AssertionError) {
      throw problem;
    }
  }
  assert(performance.now() - begin < slowest, 'an input takes less than a second');
  assert(process.memoryUsage().arrayBuffers - before < mostBytes, 'a small input takes little memory');
}

async function main() {
  const [copies, seed, seconds] = process.argv.slice(2).map(Number);
  const scripts = await loadScripts();
  const random = makeRandom(seed);
  const inputs = [...makeVolumeFiles().map((bytes) => [readVolume, bytes]), [readIndex, index], [unpack, columns]];
  for (const [read, bytes] of inputs) {
    await read(scripts, bytes); // whole, it is read
  }
  const end = performance.now() + 1000 * (seconds || 0);
  let count = inputs.length;
  do {
    for (const [read, bytes] of inputs) {
      for (let copy = 0; copy < copies; copy++, count++) {
        let damaged = bytes;
        for (let times = random(3); times >= 0; times--) {
          damaged = damage(damaged, random);
        }
        damaged = read === readVolume && random(2) === 0 ? withHeaderLength(damaged) : damaged;
        try {
          await run(read, scripts, damaged);
        } catch (problem) {
          console.error(`${read.name} of ${damaged.toString('base64')}: ${problem.message}`);
          process.exit(1);
        }
      }
    }
  } while (performance.now() < end);
  console.log(`${count} inputs`);
}

await main();
