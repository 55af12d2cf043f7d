// SPDX-License-Identifier: BSD-3-Clause
// Bytes of the page and of files: base64, zlib streams.

export function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; i++) {
    bytes[i] = binary.charCodeAt(i);
  }
  return bytes;
}

// Inflates a zlib stream (RFC 1950) of at most so many bytes: a few bytes may stand for gigabytes.
export async function inflate(bytes, most = Infinity) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  let count = 0;
  const counter = new TransformStream({
    transform(piece, controller) {
      count += piece.length;
      if (count > most) {
        throw new Error(`it has more than ${most} bytes when it is inflated`);
      }
      controller.enqueue(piece);
    },
  });
  return new Uint8Array(await new Response(stream.pipeThrough(counter)).arrayBuffer());
}
