# SPDX-License-Identifier: BSD-3-Clause
"""Reads PNG pictures of 8 bits a colour and compares them."""

import pathlib
import struct
import zlib


def paeth(left, above, corner):
    """The predictor of PNG's filter 4."""
    estimate = left + above - corner
    ways = abs(estimate - left), abs(estimate - above), abs(estimate - corner)
    return left if ways[0] <= ways[1] and ways[0] <= ways[2] else above if ways[1] <= ways[2] else corner


def undo_filter(kind, line, above, step):
    for i, value in enumerate(line):
        left = line[i - step] if i >= step else 0
        corner = above[i - step] if i >= step else 0
        if kind == 1:
            value += left
        elif kind == 2:
            value += above[i]
        elif kind == 3:
            value += (left + above[i]) // 2
        elif kind == 4:
            value += paeth(left, above[i], corner)
        line[i] = value & 255


def read_png(path):
    """Width, height and the lines of a picture: bytes of red, green and blue."""
    data = pathlib.Path(path).read_bytes()
    place, packed = 8, b""
    while place < len(data):
        count, kind = struct.unpack_from(">I4s", data, place)
        chunk = data[place + 8:place + 8 + count]
        if kind == b"IHDR":
            width, height, depth, colours = struct.unpack_from(">IIBB", chunk)
            if depth != 8 or colours not in (2, 6):
                raise ValueError(f"{path}: neither RGB nor RGBA of 8 bits")
        elif kind == b"IDAT":
            packed += chunk
        place += 12 + count
    step = 4 if colours == 6 else 3
    raw = zlib.decompress(packed)
    lines, above = [], bytearray(width * step)
    for y in range(height):
        start = y * (width * step + 1)
        line = bytearray(raw[start + 1:start + 1 + width * step])
        if raw[start] != 0:
            undo_filter(raw[start], line, above, step)
        above = line
        if step == 4:
            line = bytes(b"".join(line[i:i + 3] for i in range(0, len(line), 4)))
        lines.append(bytes(line))
    return width, height, lines


def mean_difference(one, other):
    """Mean over all pixels and colours of the absolute difference, 0 to 255."""
    first, second = read_png(one), read_png(other)
    if first[:2] != second[:2]:
        raise ValueError(f"{one} and {other} have different sizes: {first[:2]}, {second[:2]}")
    total = sum(abs(a - b) for line, match in zip(first[2], second[2]) for a, b in zip(line, match))
    return total / (3 * first[0] * first[1])
