# SPDX-License-Identifier: MIT
"""Writes PNGs for the documents, of what programs draw."""
import re
import struct
import zlib


def filtered(kind, line, above, bpp):
    """A row of a PNG, less what its neighbours predict: nothing, left, above, mean, Paeth."""
    def predict(a, b, c):
        nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
        return (0, a, b, (a + b) // 2, nearest)[kind]

    left, corner = bytes(bpp) + line, bytes(bpp) + above
    return bytes((x - predict(a, b, c)) & 255 for x, a, b, c in zip(line, left, above, corner))


def encode_png(pnm):
    """A PPM or PGM with 8 bits as a PNG"""
    header = re.match(rb"P([56])\n(\d+) (\d+)\n255\n", pnm)
    kind, width, height = (int(field) for field in header.groups())
    bpp = 1 if kind == 5 else 3
    pixels, stride = pnm[header.end():], width * bpp
    above, rows = bytes(stride), []
    for y in range(height):
        line = pixels[stride * y:stride * (y + 1)]
        rows.append(min((bytes([kind]) + filtered(kind, line, above, bpp) for kind in range(5)),
                        key=lambda row: sum(min(byte, 256 - byte) for byte in row[1:])))
        above = line
    png = b"\x89PNG\r\n\x1a\n"
    for name, data in ((b"IHDR", struct.pack(">IIBBBBB", width, height, 8, bpp - 1, 0, 0, 0)),
                       (b"IDAT", zlib.compress(b"".join(rows), 9)), (b"IEND", b"")):
        png += struct.pack(">I", len(data)) + name + data
        png += struct.pack(">I", zlib.crc32(name + data))
    return png
