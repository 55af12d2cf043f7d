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
