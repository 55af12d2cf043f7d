// SPDX-License-Identifier: BSD-3-Clause
// What the scripts of a page do with files that are not as they should be. Node runs the scripts as they are.
import { strict as assert } from 'node:assert';
import { cpSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { deflateSync } from 'node:zlib';

// The scripts are modules without a package around them, which Node wants.
const folder = mkdtempSync(join(tmpdir(), 'nexrad-page-'));
process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
cpSync(join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'Source', 'Web', 'Scripts'), folder, { recursive: true });
writeFileSync(join(folder, 'package.json'), '{"type": "module"}');
const { FolderSeries } = await import(pathToFileURL(join(folder, 'series.js')).href);

const size = [5, 4, 3];
const scene = { series: 'day.nxv.series', size, array: 'REF', scale: { first: -33, step: 0.5 }, masked: true };

function fileOf(type, encoding, payload, change = () => {}) {
  const array = { name: 'REF', type, offset: -33, scale: 0.5, fill: -33, encoding, length: payload.length };
  const header = { dimensions: size, arrays: [array] };
  change(header);
  const text = Buffer.from(JSON.stringify(header));
  const start = Buffer.from('NXV1\0\0\0\0');
  start.writeUInt32LE(text.length, 4);
  return Buffer.concat([start, text, payload]);
}

const read = (bytes) => new FolderSeries(scene, async () => new Response(bytes)).read('a.nxv');
const refused = (bytes, message) => assert.rejects(read(bytes), { message: `a.nxv: ${message}` });
const codes = deflateSync(Buffer.alloc(60, 40));

assert.equal((await read(fileOf('uint8', 'deflate', codes))).bytes.length, 60);
// 64 MB of zeros in 64 kB: they all came out before their number was looked at.
await refused(fileOf('uint8', 'deflate', deflateSync(Buffer.alloc(64e6))), 'it has more than 60 bytes when it is inflated');
// The voxels without codes were drawn as no echo.
await refused(fileOf('uint8', 'deflate', deflateSync(Buffer.alloc(59, 40))), 'it has 59 bytes of codes, not 60');
await refused(fileOf('uint7', 'rle', Buffer.from([0, 61, 0, 0, 0])), 'it has more codes than voxels');
for (const change of [(header) => { header.arrays = []; }, (header) => { delete header.arrays; },
  (header) => { header.arrays[0].length = -1; }, (header) => { header.arrays[0].type = 'toString'; },
  (header) => { header.dimensions = 60; }]) {
  await refused(fileOf('uint8', 'deflate', codes, change), 'its header is damaged');
}

const index = (files) => new FolderSeries(scene, async () => new Response(JSON.stringify({ files }))).refresh();
assert.equal(await index([{ name: 'a.nxv', time: 1142186400 }]), true);
// An entry without a time had a time that is no number.
for (const files of [[{ name: 'a.nxv' }], [{ name: 'a.nxv', time: 1e308 }], [{ name: 1, time: 1 }], [null], 'a.nxv', undefined]) {
  await assert.rejects(index(files), { message: 'day.nxv.series is no index of a series.' });
}

// Volume files in bricks, of which parts are read.
const { BrickFile } = await import(pathToFileURL(join(folder, 'brickFile.js')).href);
const { BrickStore } = await import(pathToFileURL(join(folder, 'brickStore.js')).href);
const { RemoteFile, joinParts } = await import(pathToFileURL(join(folder, 'remoteFile.js')).href);
const { chooseDetail, Detail } = await import(pathToFileURL(join(folder, 'detail.js')).href);
const { findSeen } = await import(pathToFileURL(join(folder, 'seen.js')).href);
const { Camera } = await import(pathToFileURL(join(folder, 'camera.js')).href);

const dimensions = [37, 21, 9];
const brick = [16, 8, 4];
const sizeIn = (voxels) => dimensions.map((count, axis) => Math.ceil(count / voxels[axis]));
// A code for each voxel of a level; most bricks in the south have one code alone.
const codeAt = (voxels, [x, y, z]) =>
  (y * voxels[1] < 8 && x * voxels[0] < 16 ? 1 : 2 + ((x * 7 + y * 5 + z * 3 + voxels[0] * 40) % 200));

function eachVoxel(begin, end, work) {
  for (let z = begin[2]; z < end[2]; z++) {
    for (let y = begin[1]; y < end[1]; y++) {
      for (let x = begin[0]; x < end[0]; x++) {
        work([x, y, z]);
      }
    }
  }
}

// The lower bytes of all voxels, then the higher ones.
function bytesOfCodes(type, all) {
  return Buffer.from(type === 'uint16' ? [...all.map((code) => code & 255), ...all.map((code) => code >> 8)] : all);
}

function bricksOf(type, voxels, factor) {
  const extent = sizeIn(voxels);
  const index = [];
  const streams = [];
  const along = extent.map((count, axis) => Math.ceil(count / brick[axis]));
  for (let y = 0; y < along[1]; y++) {
    for (let x = 0; x < along[0]; x++) {
      for (let z = 0; z < along[2]; z++) {
        const begin = [x, y, z].map((place, axis) => place * brick[axis]);
        const all = [];
        eachVoxel(begin, begin.map((place, axis) => Math.min(place + brick[axis], extent[axis])),
          (place) => all.push(codeAt(voxels, place) * factor));
        const stream = all.every((code) => code === all[0]) ? Buffer.alloc(0) : deflateSync(bytesOfCodes(type, all));
        streams.push(stream);
        const entry = Buffer.alloc(8);
        entry.writeUInt32LE(stream.length, 0);
        entry.writeUInt32LE(all[0], 4);
        index.push(entry);
      }
    }
  }
  return { index: Buffer.concat(index), bricks: Buffer.concat(streams) };
}

const halves = [2, 2, 1];
function brickFile(type, { factor = 1, change = () => {}, damageIndex = (index) => index, fill = 'REF_state' } = {}) {
  const payloads = [];
  const arrayOf = (voxels) => {
    const { index, bricks } = bricksOf(type, voxels, factor);
    const packed = deflateSync(damageIndex(index));
    payloads.push(packed, bricks);
    return { name: 'REF', type, offset: -33, scale: 0.5 / factor, fill: -33, encoding: 'bricks', brick,
      length: packed.length + bricks.length, index_length: packed.length };
  };
  const other = { name: fill, type: 'uint8', encoding: 'deflate', length: 5 };
  const withOther = (array) => {
    payloads.push(Buffer.alloc(5));
    return [array, other];
  };
  const header = { dimensions, arrays: withOther(arrayOf([1, 1, 1])),
    levels: [{ voxels: halves, arrays: withOther(arrayOf(halves)) }] };
  change(header);
  const text = Buffer.from(JSON.stringify(header));
  const start = Buffer.from('NXV1\0\0\0\0');
  start.writeUInt32LE(text.length, 4);
  return Buffer.concat([start, text, ...payloads]);
}

// A server of one file. `parts`: it knows parts. `asked`: what it was asked for.
function serverOf(bytes, { parts = true, answer = () => null } = {}) {
  const asked = [];
  const fetchFile = async (name, { headers, signal }) => {
    signal?.throwIfAborted();
    const [from, last] = headers.Range.match(/\d+/g).map(Number);
    asked.push({ from, count: last + 1 - from, signal });
    const part = bytes.subarray(from, last + 1);
    return answer(asked.length, part, from) ?? (parts
      ? new Response(part, { status: 206,
        headers: { 'Content-Range': `bytes ${from}-${from + part.length - 1}/${bytes.length}` } })
      : new Response(bytes));
  };
  return { fetchFile, asked };
}

const brickScene = { series: 'day.nxv.series', bricks: true, size: sizeIn(halves), array: 'REF',
  scale: { first: -33, step: 0.5 }, masked: true };
const openBricks = (server) => BrickFile.open(new RemoteFile(server.fetchFile, 'a.nxv'), brickScene);
// Code 1 is no value, the others are their own bytes: scale and first value are those of the page.
const expectedIn = (voxels, { begin, end }, leastValue = 2) => {
  const bytes = [];
  eachVoxel(begin, end, (place) => bytes.push(codeAt(voxels, place) < leastValue ? 0 : codeAt(voxels, place)));
  return bytes;
};
const boxes = [{ begin: [0, 0, 0], end: [37, 21, 9] }, { begin: [15, 7, 3], end: [17, 9, 5] },
  { begin: [36, 20, 8], end: [37, 21, 9] }, { begin: [3, 2, 0], end: [30, 21, 2] }];

for (const [type, factor] of [['uint8', 1], ['uint16', 1], ['uint16', 256]]) {
  for (const parts of [true, false]) {
    const server = serverOf(brickFile(type, { factor }), { parts });
    const file = await openBricks(server);
    assert.deepEqual(file.levels.map((level) => level.size), [dimensions, [19, 11, 9]]);
    assert.equal(file.levelOf([19, 11, 9]), 1);
    assert.equal(file.levelOf([19, 11, 8]), -1);
    const leastValue = factor === 1 ? 2 : 1; // codes of 256 times as much, of which 256 is a value
    assert.deepEqual([...await file.readLevel(1)], expectedIn(halves, { begin: [0, 0, 0], end: [19, 11, 9] }, leastValue), type);
    for (const box of boxes) {
      assert.deepEqual([...await file.read(0, box)], expectedIn([1, 1, 1], box, leastValue), `${type} ${box.begin}`);
    }
    assert.equal(server.asked.length > 3, parts, 'one answer with the whole file is enough');
  }
}

// Without a mask, no value is the first one; a header longer than the first request is read by another one.
{
  const long = serverOf(brickFile('uint8', { change: (header) => { header.notes = ['x'.repeat(20000)]; } }));
  const file = await BrickFile.open(new RemoteFile(long.fetchFile, 'a.nxv'), { ...brickScene, masked: false });
  assert.equal((await file.read(0, boxes[0]))[0], 0);
  assert.equal(long.asked[1].from, 0);
}

// What is damaged is an error, and no more is read than the header promises.
const readBricks = (server) => new FolderSeries(brickScene, server.fetchFile).read('a.nxv');
const refusedBricks = (server, message) => assert.rejects(readBricks(server), { message: `a.nxv: ${message}` });
const ofServer = (options) => serverOf(brickFile('uint8', options));
assert.equal((await readBricks(ofServer())).bytes.length, 19 * 11 * 9);
for (const change of [(header) => { header.levels[0].arrays = []; }, (header) => { header.levels[0].voxels = [2, 2]; },
  (header) => { header.levels[0].voxels = [0, 2, 1]; }, (header) => { header.levels[0].arrays[0].name = 'VEL'; },
  (header) => { header.levels[0].arrays[0].length = -1; }, (header) => { header.levels[0].arrays[0].brick = [1, 1, 1]; },
  (header) => { header.levels[0].arrays[0].brick = 512; }, (header) => { header.levels[0].arrays[0].index_length = 1e9; },
  (header) => { header.levels[0].arrays[0].encoding = 'deflate'; }, (header) => { header.levels[0].arrays[1].length = 'long'; },
  (header) => { header.levels[0].arrays[0].type = 'uint7'; }, (header) => { header.levels[0].arrays[0].scale = null; },
  (header) => { header.levels = [null]; }, (header) => { header.dimensions = [37, 21]; }]) {
  await refusedBricks(ofServer({ change }), 'its header is damaged');
}
await refusedBricks(ofServer({ change: (header) => { header.arrays[0].encoding = 'deflate'; } }),
  'it is not in bricks, and the page was made for volumes that are; make the page again');
await refusedBricks(ofServer({ change: (header) => { header.levels = []; } }),
  'it has another grid or moment than the page was made for');
await refusedBricks(ofServer({ damageIndex: (index) => index.subarray(8) }), 'its index does not fit its bricks');
await refusedBricks(ofServer({ damageIndex: (index) => Buffer.concat([index, index]) }),
  'it has more than 96 bytes when it is inflated');
const longerBrick = (index) => {
  const other = Buffer.from(index);
  other.writeUInt32LE(index.readUInt32LE(index.length - 8) + 1, index.length - 8);
  return other;
};
await refusedBricks(ofServer({ damageIndex: longerBrick }), 'its index does not fit its bricks');
// The index of so many bricks would take gigabytes.
{
  const many = ofServer({ change: (header) => {
    header.dimensions = [2 ** 15, 2 ** 14, 1];
    header.arrays[0].brick = [1, 1, 512];
  } });
  await assert.rejects((await openBricks(many)).read(0, boxes[1]), { message: 'it has too many bricks' });
}
const whole = brickFile('uint8');
const damaged = Buffer.from(whole);
damaged.fill(255, whole.length - 60, whole.length - 20); // in a brick of the coarse level
await assert.rejects(readBricks(serverOf(damaged)), { message: /^a.nxv: a brick is damaged: / });
for (const parts of [true, false]) {
  await refusedBricks(serverOf(whole.subarray(0, whole.length - 40), { parts }), 'the file ends too early');
  await refusedBricks(serverOf(whole.subarray(0, 6), { parts }), 'the file ends too early');
  await refusedBricks(serverOf(Buffer.from('<!DOCTYPE html>'), { parts }), 'it is no volume file');
}
await refusedBricks(serverOf(whole, { answer: () => new Response('', { status: 404 }) }),
  'it cannot be read from the server (404)');
await refusedBricks(serverOf(whole, { answer: (count) => (count < 2 ? null : new Response('', { status: 503 })) }),
  'it cannot be read from the server (503)');
const elsewhere = (count, part) => new Response(part, { status: 206, headers: { 'Content-Range': 'bytes 7-9/10' } });
await refusedBricks(serverOf(whole, { answer: elsewhere }),
  'the server sends another part of it than was asked for');
const versioned = (count, part, from) => new Response(part, { status: 206,
  headers: { ETag: count < 3 ? '"1"' : '"2"', 'Content-Range': `bytes ${from}-/*` } });
await refusedBricks(serverOf(whole, { answer: versioned }), 'it was replaced on the server while it was read');
// A page that was made for files that are not in bricks.
const otherScene = { ...brickScene, bricks: undefined, size: dimensions };
await assert.rejects(new FolderSeries(otherScene, async () => new Response(whole)).read('a.nxv'),
  { message: /^a.nxv: it is in bricks, .* make the page again$/ });

// The first brick of the fine level has one code, so the others would still fill the payload without its entry.
await assert.rejects((await openBricks(ofServer({ damageIndex: (index) => index.subarray(8) }))).read(0, boxes[0]),
  { message: 'its index does not fit its bricks' });
// An index that could not be read once is read again.
{
  const file = await openBricks(serverOf(whole, { answer: (count) => (count === 2 ? new Response('', { status: 503 }) : null) }));
  await assert.rejects(file.read(0, boxes[0]), { message: 'it cannot be read from the server (503)' });
  assert.equal((await file.read(0, boxes[0])).length, 37 * 21 * 9);
}

// What lies close together comes in one answer.
const part = (offset, length) => ({ offset, length });
assert.deepEqual(joinParts([part(0, 10), part(10, 5), part(16000, 5), part(40000, 5)]).map(({ offset, end }) => [offset, end]),
  [[0, 16005], [40000, 40005]]);
assert.equal(joinParts([part(0, 600000), part(600000, 600000)]).length, 2);

// Bricks that were used last are kept.
{
  const store = new BrickStore(100);
  store.put('a', new Uint8Array(40));
  store.put('b', new Uint8Array(40));
  store.get('a');
  store.put('c', new Uint8Array(40));
  assert.deepEqual(['a', 'b', 'c'].map((key) => store.get(key)?.length), [40, undefined, 40]);
}

// What the camera sees of a domain of 400 km by 300 km by 20 km.
const domain = [-200, 200, -150, 150, 0, 20];
const near = (values, expected, within) => values.forEach((value, i) =>
  assert.ok(Math.abs(value - expected[i]) <= within, `${values} ${expected}`));
const above = (focus, distance, parallel = false) =>
  new Camera({ azimuth: 180, tilt: 90, zoom: 1, parallel }, { focus, distance }, 800, 400);
{
  const half = Math.tan(Math.PI / 12);
  const seen = findSeen(above([50, 20, 0], 120), domain);
  near(seen.faces, [50 - 240 * half, 50 + 240 * half, 20 - 120 * half, 20 + 120 * half], 1e-6); // at the ground
  near([seen.pixel], [(2 * half * 100) / 400], 1e-9); // at the top, 100 km away
  near(findSeen(above([50, 20, 0], 30, true), domain).faces, [-10, 110, -10, 50], 1e-6);
  near([findSeen(above([50, 20, 0], 30, true), domain).pixel], [0.15], 1e-9);
  assert.equal(findSeen(above([900, 20, 0], 120), domain), null);
  for (const distance of [10, 20.5]) { // within the domain, and half a km above it: 1 km before the camera
    near([findSeen(above([50, 20, 0], distance), domain).pixel], [(2 * half) / 400], 1e-9);
  }
}

// The level that has voxels as large as the pixels, and one voxel more on each side.
const levels = [[1, 1, 1], [2, 2, 1], [4, 4, 1]].map((voxels) => ({ voxels, size: [400 / voxels[0], 300 / voxels[1], 10] }));
const choose = (faces, pixel, bytes = 1) => chooseDetail(levels, 2, domain, { faces, pixel }, bytes);
assert.deepEqual(choose([-10.5, 11.5, 0.5, 20], 0.5), { level: 0, block: { begin: [188, 149, 0], end: [216, 171, 10] } });
assert.equal(choose([-10, 10, 0, 20], 1.9).level, 0);
assert.equal(choose([-10, 10, 0, 20], 2).level, 1);
assert.equal(choose([-10, 10, 0, 20], 4), null);
assert.deepEqual(choose([-200, 200, -150, 150], 0.5).block, { begin: [0, 0, 0], end: [400, 300, 10] });
{
  const many = [[1, 1, 1], [2, 2, 1], [4, 4, 1]].map((voxels) => ({ voxels, size: [2000 / voxels[0], 1500 / voxels[1], 32] }));
  const chooseOfMany = (bytes, across) =>
    chooseDetail(many, 2, domain, { faces: [-across, across, -150, 150], pixel: 0.01 }, bytes)?.level;
  // A mask takes a byte more. Of the last there is no room for more than the whole has.
  const views = [[1, 50], [2, 50], [1, 200], [2, 200]];
  assert.deepEqual(views.map(([bytes, across]) => chooseOfMany(bytes, across)), [0, 1, 1, undefined]);
}

// A detail is read once, and left off when the camera moves on.
{
  const server = serverOf(whole);
  const series = new FolderSeries(brickScene, server.fetchFile);
  series.names = ['a.nxv'];
  const frame = await series.load(0);
  const shown = [];
  const said = [];
  const detail = new Detail(brickScene, series, (one) => shown.push(one), (text) => said.push(text));
  const box = [0, 38, 0, 22, 0, 9];
  const follow = (faces, pixel = 0.1) => detail.follow(0, frame, { faces, pixel }, box);
  await follow([20, 23, 2, 5]);
  assert.deepEqual([...shown[0].frame.bytes], expectedIn([1, 1, 1], { begin: [16, 1, 0], end: [24, 6, 9] }));
  near([...shown[0].lower, ...shown[0].upper], [16 / 38, 1 / 22, 0, 24 / 38, 6 / 22, 1], 1e-12);
  let count = server.asked.length;
  await follow([21, 23, 3, 5]); // lies in it
  assert.deepEqual([shown.length, server.asked.length], [1, count]);
  await follow([20, 30, 10, 20]);
  count = server.asked.length;
  await follow([20, 23, 2, 5]); // again: its bricks were kept
  assert.deepEqual([shown.length, server.asked.length], [3, count]);
  await follow([20, 23, 2, 5], 9);
  assert.equal(shown[3], null, 'the whole volume is fine enough');
  assert.equal(detail.loading, false);

  const moving = new Detail(brickScene, series, (one) => shown.push(one), (text) => said.push(text));
  const held = [];
  series.fetchFile = null;
  const { file } = await series.open(0);
  const fetchNow = file.remote.fetchFile;
  file.remote.fetchFile = (name, options) => new Promise((resolve, reject) => {
    options.signal?.addEventListener('abort', () => reject(options.signal.reason));
    held.push(() => options.signal?.aborted || resolve(fetchNow(name, options)));
  });
  const first = moving.follow(0, frame, { faces: [20, 23, 2, 5], pixel: 0.1 }, box);
  await new Promise((resolve) => setTimeout(resolve, 10));
  const second = moving.follow(0, frame, { faces: [30, 36, 15, 20], pixel: 0.1 }, box);
  await first;
  assert.equal(moving.loading, true);
  await new Promise((resolve) => setTimeout(resolve, 10));
  held.forEach((go) => go());
  await second;
  assert.deepEqual([shown.length, shown[4].block.begin[0], said.length, moving.loading], [5, 28, 0, false]);

  // A failure is said once, the picture stays, and what is read next takes the words away.
  file.remote.fetchFile = async () => new Response('', { status: 500 });
  await moving.follow(0, frame, { faces: [20, 23, 2, 5], pixel: 0.1 }, box);
  assert.deepEqual([shown.length, said], [5, ['a.nxv: it cannot be read from the server (500)']]);
  series.fetchFile = server.fetchFile;
  await moving.follow(0, frame, { faces: [20, 23, 2, 5], pixel: 0.1 }, box);
  assert.deepEqual([shown.length, said.at(-1)], [6, '']);
}

// Radars in words: many are counted.
const { namesOf } = await import(pathToFileURL(join(folder, 'captions.js')).href);
const radars = Array.from({ length: 17 }, (_, i) => `K${i}`);
assert.deepEqual(namesOf(radars.slice(1)), radars.slice(1));
assert.deepEqual(namesOf(radars), ['17 radars']);
