// Makes Data/letters.ttf and Data/letters_bold.ttf from the npm package @fontsource/inter 5.3.0: the faces Inter Medium
// and Inter Bold with the Latin letters. The package has them as WOFF, whose tables are compressed one by one; this
// writes the same tables as TrueType, which every FreeType reads.
//
//   npm install --prefix /tmp/letters @fontsource/inter@5.3.0
//   node Utilities/make-letters.mjs /tmp/letters/node_modules
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import { fileURLToPath } from 'node:url';

const repository = path.join(path.dirname(fileURLToPath(import.meta.url)), '..');
const WOFF_HEADER = 44;
const WOFF_ENTRY = 20;
const TTF_HEADER = 12;
const TTF_ENTRY = 16;

function readTables(woff) {
  return Array.from({ length: woff.readUInt16BE(12) }, (_, i) => {
    const entry = WOFF_HEADER + WOFF_ENTRY * i;
    const [offset, stored, length] = [4, 8, 12].map((place) => woff.readUInt32BE(entry + place));
    const bytes = woff.subarray(offset, offset + stored);
    return {
      tag: woff.subarray(entry, entry + 4),
      checksum: woff.readUInt32BE(entry + 16),
      bytes: stored < length ? zlib.inflateSync(bytes) : bytes,
    };
  });
}

function writeTrueType(flavour, tables) {
  const power = Math.floor(Math.log2(tables.length));
  const head = Buffer.alloc(TTF_HEADER + TTF_ENTRY * tables.length);
  head.writeUInt32BE(flavour, 0);
  [tables.length, 16 << power, power, 16 * tables.length - (16 << power)].forEach((value, i) =>
    head.writeUInt16BE(value, 4 + 2 * i));
  const parts = [head];
  let offset = head.length;
  tables.forEach(({ tag, checksum, bytes }, i) => {
    const entry = TTF_HEADER + TTF_ENTRY * i;
    tag.copy(head, entry);
    [checksum, offset, bytes.length].forEach((value, k) => head.writeUInt32BE(value, entry + 4 + 4 * k));
    const padding = (4 - (bytes.length % 4)) % 4;
    parts.push(bytes, Buffer.alloc(padding));
    offset += bytes.length + padding;
  });
  return Buffer.concat(parts);
}

const folder = process.argv[2];
if (folder === undefined) {
  console.error('usage: make-letters.mjs FOLDER-OF-NODE-MODULES');
  process.exit(2);
}
for (const [weight, name] of [[500, 'letters.ttf'], [700, 'letters_bold.ttf']]) {
  const woff = fs.readFileSync(path.join(folder, `@fontsource/inter/files/inter-latin-${weight}-normal.woff`));
  const file = path.join(repository, 'Data', name);
  const bytes = writeTrueType(woff.readUInt32BE(4), readTables(woff));
  fs.writeFileSync(file, bytes);
  console.log(`${file}: ${bytes.length} bytes`);
}
