// What the scripts share that make the files of the map in Data.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const REACH_DEGREES = 8; // what is farther than this from every radar is left out

export const repository = path.join(path.dirname(fileURLToPath(import.meta.url)), '..');

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

const radars = radarPositions();

// True for a point [longitude, latitude] near a radar.
export function withinReach([x, y], reach = REACH_DEGREES) {
  return radars.some(([a, b]) => Math.abs(x - a) < reach && Math.abs(y - b) < reach);
}

// Seven bits a byte, the lowest first.
export function pushUnsigned(bytes, value) {
  while (value >= 0x80) {
    bytes.push((value & 0x7f) | 0x80);
    value >>>= 7;
  }
  bytes.push(value);
}

// 0, -1, 1, -2, 2, … as 0, 1, 2, 3, 4, …
export function pushSigned(bytes, value) {
  pushUnsigned(bytes, value < 0 ? -2 * value - 1 : 2 * value);
}

export function write(name, content, what) {
  const file = path.join(repository, 'Data', name);
  fs.writeFileSync(file, content);
  console.log(`${file}: ${what}, ${content.length} bytes`);
}
