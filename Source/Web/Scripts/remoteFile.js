// SPDX-License-Identifier: BSD-3-Clause
// A file on a server, of which parts are read (RFC 9110, section 14).
import { ByteCollector } from './nxv.js';

const farApart = 16384; // bytes that cost less than one more request
const mostAtOnce = 1048576; // bytes of a request for several parts, so that stopping one loses little

export class RemoteFile {
  constructor(fetchFile, address) {
    Object.assign(this, { fetchFile, address, whole: null, version: null });
  }

  // `count` bytes from `from` on; `orFewer`: or those until the end of the file. A server that does not know parts sends the
  // whole file, of which the others are then taken.
  async read(from, count, { signal, orFewer = false } = {}) {
    if (this.whole === null) {
      // The browser's own cache would answer one request after the other.
      const response = await this.fetchFile(this.address,
        { cache: 'no-store', headers: { Range: `bytes=${from}-${from + count - 1}` }, signal });
      if (response.status === 206) {
        return this.takePart(response, from, count, orFewer);
      }
      if (response.status !== 200 || from !== 0) {
        throw new Error(`it cannot be read from the server (${response.status})`);
      }
      this.whole = new ByteCollector(response.body.getReader());
    }
    const bytes = await this.whole.collect(from + count, orFewer);
    return bytes.subarray(from, from + count);
  }

  async takePart(response, from, count, orFewer) {
    this.checkVersion(response.headers);
    if (!(response.headers.get('Content-Range') ?? '').startsWith(`bytes ${from}-`)) {
      throw new Error('the server sends another part of it than was asked for');
    }
    const reader = response.body.getReader();
    const bytes = await new ByteCollector(reader).collect(count, orFewer);
    reader.cancel().catch(() => {});
    return bytes.subarray(0, count);
  }

  // Parts of two files would not fit together.
  checkVersion(headers) {
    const version = headers.get('ETag') ?? headers.get('Last-Modified');
    this.version ??= version;
    if (version !== this.version) {
      throw new Error('it was replaced on the server while it was read');
    }
  }
}

// Puts parts (offset, length; in the order of the file) that lie close together into one request each.
export function joinParts(parts) {
  const joined = [];
  for (const part of parts) {
    const last = joined.at(-1);
    const end = part.offset + part.length;
    if (last !== undefined && part.offset - last.end <= farApart && end - last.offset <= mostAtOnce) {
      last.end = end;
      last.parts.push(part);
    } else {
      joined.push({ offset: part.offset, end, parts: [part] });
    }
  }
  return joined;
}
