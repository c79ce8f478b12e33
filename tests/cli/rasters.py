# SPDX-License-Identifier: MIT
"""Readers of the raster formats that scarp writes, made from the formats' descriptions.

They share nothing with the program, and need nothing but zlib. Every reader checks what the
format says about a file, and returns a Picture: width, height, channels, depth in bits (32 for
floats) and rows, top row first; a row is a list of samples, tuples where there are channels.
"""
import array
import ast
import itertools
import re
import struct
import sys
import zlib

FLOAT, U8, U16_LOW, U16_HIGH = "f", "B", "H low", "H high"


def numbers(data, kind):
    """Samples from bytes; 16-bit ones as the kind says, floats with the low byte first."""
    values = array.array(kind[0])
    values.frombytes(data)
    order = "big" if kind == U16_HIGH else "little"
    if sys.byteorder != order:
        values.byteswap()
    return values


class Picture:
    def __init__(self, width, height, channels, kind, data):
        self.width, self.height, self.channels = width, height, channels
        samples = numbers(data, kind)
        self.depth = samples.itemsize * 8
        assert len(samples) == width * height * channels, "length of the samples"
        pixels = samples.tolist()
        if channels > 1:
            pixels = list(zip(*[iter(pixels)] * channels))
        self.rows = [pixels[i * width:(i + 1) * width] for i in range(height)]

    def flat(self):
        return [sample for row in self.rows for sample in row]

    def shape(self):
        return self.width, self.height, self.channels, self.depth


def unfilter(kind, line, above, bpp):
    """PNG specification, section 9."""
    if kind == 0:
        return
    if kind == 3:  # the one of heights, normals and hillshade
        for i in range(bpp):
            line[i] = (line[i] + above[i] // 2) & 255
        for i in range(bpp, len(line)):
            line[i] = (line[i] + (line[i - bpp] + above[i]) // 2) & 255
        return
    for i in range(len(line)):
        a = line[i - bpp] if i >= bpp else 0
        b = above[i]
        if kind == 4:
            c = above[i - bpp] if i >= bpp else 0
            p = a + b - c
            _, predicted = min((abs(p - a), 0), (abs(p - b), 1), (abs(p - c), 2))
            predicted = (a, b, c)[predicted]
        else:
            predicted = (None, a, b)[kind]
        line[i] = (line[i] + predicted) & 255


def png_chunks(data):
    """The name and the data of each, in their order."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "signature"
    at, chunks = 8, []
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        checksum, = struct.unpack(">I", data[at + 8 + length:at + 12 + length])
        assert checksum == zlib.crc32(name + body), "checksum"
        chunks.append((name, body))
        at += 12 + length
    return chunks


def decode_png(data):
    chunks = png_chunks(data)
    assert chunks[0][0] == b"IHDR" and chunks[-1] == (b"IEND", b""), "first and last chunk"
    width, height, depth, colour, method, filters, interlace = struct.unpack(">IIBBBBB",
                                                                             chunks[0][1])
    assert colour in (0, 2, 6) and (method, filters, interlace) == (0, 0, 0), "kind"
    channels = {0: 1, 2: 3, 6: 4}[colour]
    raw = zlib.decompress(b"".join(body for name, body in chunks if name == b"IDAT"))
    bpp = channels * depth // 8
    stride = width * bpp
    assert len(raw) == height * (stride + 1), "length"
    above, lines = bytearray(stride), []
    for i in range(height):
        line = bytearray(raw[i * (stride + 1) + 1:(i + 1) * (stride + 1)])
        unfilter(raw[i * (stride + 1)], line, above, bpp)
        lines.append(line)
        above = line
    return Picture(width, height, channels, U16_HIGH if depth == 16 else U8, b"".join(lines))


def decode_pnm(data):
    header = re.match(rb"P([56])\n(\d+) (\d+)\n(\d+)\n", data)
    kind, width, height, maximum = (int(field) for field in header.groups())
    assert maximum in (255, 65535), "maximum"
    return Picture(width, height, 1 if kind == 5 else 3, U8 if maximum == 255 else U16_HIGH,
                   data[header.end():])


def decode_pfm(data):
    """The sign of the scale tells the byte order, its magnitude a unit; rows go upward."""
    kind, size, scale, samples = data.split(b"\n", 3)
    assert kind in (b"Pf", b"PF") and scale == b"-1.0", (kind, scale)
    width, height = (int(number) for number in size.split(b" "))
    picture = Picture(width, height, 1 if kind == b"Pf" else 3, FLOAT, samples)
    picture.rows.reverse()
    return picture


def decode_npy(data):
    """NumPy's format 1.0: the header is a Python literal."""
    assert data[:8] == b"\x93NUMPY\x01\x00", data[:8]
    length, = struct.unpack("<H", data[8:10])
    assert (10 + length) % 64 == 0, "NumPy aligns what follows the header"
    header = data[10:10 + length]
    assert header.endswith(b"\n"), "the header ends with a newline"
    fields = ast.literal_eval(header.decode("latin-1").strip())
    assert set(fields) == {"descr", "fortran_order", "shape"} and not fields["fortran_order"]
    height, width, *channels = fields["shape"]
    assert channels in ([], [2], [3]), channels
    return Picture(width, height, channels[0] if channels else 1,
                   {"<f4": FLOAT, "|u1": U8}[fields["descr"]], data[10 + length:])


def decode_envi_header(text):
    """The fields, by their names: texts, and lists where there are braces."""
    first, rest = text.split("\n", 1)
    assert first == "ENVI" and rest.endswith("\n"), text
    fields = {}
    for line in rest[:-1].split("\n"):
        name, value = line.split(" = ", 1)
        assert name not in fields, name
        if value.startswith("{"):
            assert value.endswith("}"), value
            value = [part.strip() for part in value[1:-1].split(",")]
        fields[name] = value
    return fields


def decode_envi(data, header):
    fields = decode_envi_header(header)
    wanted = {"description", "samples", "lines", "bands", "header offset", "file type",
              "data type", "interleave", "byte order", "map info"}
    assert set(fields) == wanted, fields
    assert fields["header offset"] == "0" and fields["file type"] == "ENVI Standard", fields
    assert fields["interleave"] == "bip" and fields["byte order"] == "0", fields
    return Picture(int(fields["samples"]), int(fields["lines"]), int(fields["bands"]),
                   {"1": U8, "4": FLOAT}[fields["data type"]], data)


def envi_corner(header):
    """What `map info` says: x and y of the upper left corner of the first pixel, and its size."""
    projection, column, row, x, y, *size = decode_envi_header(header)["map info"]
    assert (projection, column, row) == ("Arbitrary", "1", "1"), header
    assert len(size) == 2 and size[0] == size[1], header
    return float(x), float(y), float(size[0])


TIFF_TYPES = {2: "s", 3: "H", 4: "I", 12: "d", 16: "Q"}


def tiff_tags(data):
    """The entries of the only directory, by their numbers: lists of values, or bytes. What the file
    says of offsets must hold: the directory ends it, and no value lies beyond."""
    assert data[:2] == b"II", "byte order"
    version, = struct.unpack_from("<H", data, 2)
    assert version in (42, 43), "version"
    big = version == 43
    if big:
        assert struct.unpack_from("<HH", data, 4) == (8, 0), "bytes of an offset"
    word, entry, counts = ("Q", 20, "Q") if big else ("I", 12, "H")
    at, = struct.unpack_from("<" + word, data, 8 if big else 4)
    assert at % 2 == 0, "directories begin at even bytes"
    count, = struct.unpack_from("<" + counts, data, at)
    at += struct.calcsize(counts)
    assert at + count * entry + struct.calcsize(word) == len(data), "the directory ends the file"
    assert data.endswith(bytes(struct.calcsize(word))), "no other directory follows"
    tags = {}
    for n in range(count):
        tag, kind, length = struct.unpack_from("<HH" + word, data, at + n * entry)
        assert not tags or tag > max(tags), "tags are sorted"
        form = "<%d%s" % (length, TIFF_TYPES[kind])
        place = at + n * entry + 4 + struct.calcsize(word)
        if struct.calcsize(form) > struct.calcsize(word):
            place, = struct.unpack_from("<" + word, data, place)
            assert place % 2 == 0 and place + struct.calcsize(form) <= len(data), "place"
        values = struct.unpack_from(form, data, place)
        tags[tag] = values[0] if kind == 2 else list(values)
    return tags


def undo_differences(values, stride, modulus):
    """Predictor 2 of TIFF 6.0, section 14: each value was subtracted from the one behind it."""
    for c in range(stride):
        values[c::stride] = [value % modulus for value in
                             itertools.accumulate(values[c::stride])]
    return values


def unpredict(line, predictor, channels, size):
    """A row of a tile as its samples' bytes"""
    if predictor == 1:
        return line
    if predictor == 2:
        if size == 1:
            return bytes(undo_differences(list(line), channels, 256))
        values = undo_differences(numbers(line, U16_LOW).tolist(), channels, 65536)
        return struct.pack("<%dH" % len(values), *values)
    planes = bytes(undo_differences(list(line), channels, 256))  # Adobe's technical note 3
    count = len(planes) // 4
    return bytes(planes[(3 - byte) * count + i] for i in range(count) for byte in range(4))


def decode_tiff(data):
    """Tiles of TIFF 6.0, section 15, with the samples of a pixel together"""
    tags = tiff_tags(data)
    width, height = tags[256][0], tags[257][0]
    bits, channels = tags[258], tags[277][0]
    assert bits == bits[:1] * channels and tags[339] == tags[339][:1] * channels, "kinds"
    kind = {(8, 1): U8, (16, 1): U16_LOW, (32, 3): FLOAT}[bits[0], tags[339][0]]
    assert tags[284] == [1] and tags[322] == tags[323] == [256], "planes and tiles"
    is_colour = channels == 3 and kind == U8
    assert tags[262] == [2 if is_colour else 1], "what colours mean"
    assert tags.get(338, []) == [0] * (channels - (3 if is_colour else 1)), "more channels"
    assert tags[259] in ([1], [8]), "compression"
    predictor = tags.get(317, [1])[0]
    assert predictor == (1 if tags[259] == [1] else 3 if kind == FLOAT else 2), "predictor"
    pixel, across = bits[0] // 8 * channels, -(-width // 256)
    assert len(tags[324]) == len(tags[325]) == across * -(-height // 256), "tiles"
    lines = [[] for _ in range(height)]
    for n, (at, size) in enumerate(zip(tags[324], tags[325])):
        tile = data[at:at + size]
        tile = zlib.decompress(tile) if tags[259] == [8] else tile
        assert len(tile) == 65536 * pixel, "a whole tile"
        for r in range(min(256, height - n // across * 256)):
            line = unpredict(tile[r * 256 * pixel:(r + 1) * 256 * pixel], predictor, channels,
                             bits[0] // 8)
            lines[n // across * 256 + r].append(line[:pixel * (width - n % across * 256)])
    return Picture(width, height, channels, kind, b"".join(b"".join(line) for line in lines))


DECODERS = {"png": decode_png, "pgm": decode_pnm, "ppm": decode_pnm, "pfm": decode_pfm,
            "npy": decode_npy, "tif": decode_tiff}


def read_bytes(path):
    with open(path, "rb") as file:
        return file.read()


def read_picture(path, kind=None):
    """A file in the format that its extension tells, unless `kind` does; r16 and r32 have no size
    and are not read here."""
    kind = kind or path.rsplit(".", 1)[1]
    if kind == "img":
        stem = path[:-len(".img")] if path.endswith(".img") else path
        return decode_envi(read_bytes(path), read_bytes(stem + ".hdr").decode())
    return DECODERS[kind](read_bytes(path))
