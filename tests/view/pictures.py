"""Pictures of codes for the tests of the window: what the virtual screen holds, and PNG files."""

import struct
import zlib


class Picture:
    """Rows of red, green, blue, as bytes."""

    def __init__(self, width, height, codes):
        self.width, self.height, self.codes = width, height, codes

    def at(self, x, y):
        start = 3 * (y * self.width + x)
        return tuple(self.codes[start:start + 3])

    def crop(self, x, y, width, height):
        rows = (self.codes[3 * ((y + r) * self.width + x):3 * ((y + r) * self.width + x + width)] for r in range(height))
        return Picture(width, height, b"".join(rows))

    def fill(self, left, top, right, bottom):
        """Makes a part black."""
        codes = bytearray(self.codes)
        for y in range(top, bottom):
            codes[3 * (y * self.width + left):3 * (y * self.width + right)] = bytes(3 * (right - left))
        self.codes = bytes(codes)

    def worst_difference(self, other):
        """The greatest difference of two codes, and how many differ."""
        assert (self.width, self.height) == (other.width, other.height)
        differences = [abs(a - b) for a, b in zip(self.codes, other.codes)]
        return max(differences), sum(d != 0 for d in differences)

    def write(self, path):
        rows = b"".join(b"\0" + self.codes[3 * self.width * y:3 * self.width * (y + 1)] for y in range(self.height))

        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

        header = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        with open(path, "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 1)) + chunk(b"IEND", b""))


def read_screen(path):
    """What Xvfb keeps with -fbdir: an X window dump of 32 bits a pixel, blue first."""
    with open(path, "rb") as file:
        data = file.read()
    fields = struct.unpack(">25I", data[:100])
    header, width, height, bits, stride, colors = fields[0], fields[4], fields[5], fields[11], fields[12], fields[19]
    assert bits == 32
    first = header + 12 * colors
    codes = bytearray(3 * width * height)
    for y in range(height):
        row = data[first + y * stride:first + y * stride + 4 * width]
        base = 3 * width * y
        for channel in range(3):
            codes[base + channel:base + 3 * width:3] = row[2 - channel::4]
    return Picture(width, height, bytes(codes))


def paeth(a, b, c):
    p = a + b - c
    pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c


def read_png(path):
    """Eight bits a channel, with alpha or without, which is left out."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            assert depth == 8 and color in (2, 6), "PNG of another kind"
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    channels = 3 if color == 2 else 4
    raw, stride = zlib.decompress(packed), channels * width
    above, codes = bytearray(stride), bytearray()
    for y in range(height):
        kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride if kind else 0):
            left = row[i - channels] if i >= channels else 0
            corner = above[i - channels] if i >= channels else 0
            guess = (left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[kind - 1]
            row[i] = (row[i] + guess) & 255
        if channels == 4:
            rgb = bytearray(3 * width)
            for channel in range(3):
                rgb[channel::3] = row[channel::4]
            codes += rgb
        else:
            codes += row
        above = row
    return Picture(width, height, bytes(codes))
