"""Makes the fonts that font_fuzz begins with: the letters A and B, and Ä where a format can put it together.

    font_seeds.py [FOLDER]
"""

import pathlib
import struct
import sys

EM = 1000
A = [[(0, 0), (300, 700), (600, 0)], [(200, 100), (300, 400), (400, 100)]]  # triangles
B = [[(100, 0), (100, 700), (500, 700), (500, 0)]]  # with the two corners at the right as control points of curves
ADVANCE = 650


def u16(*values):
    return struct.pack(f">{len(values)}H", *(value & 0xFFFF for value in values))


def u32(*values):
    return struct.pack(f">{len(values)}I", *values)


def sfnt(version, tables):
    """The file of a font; its checksums are 0, which no reader minds."""
    offset = 12 + 16 * len(tables)
    directory, data = version + u16(len(tables), 16, 0, 0), b""
    for tag, table in sorted(tables.items()):
        directory += tag.encode() + u32(0, offset + len(data), len(table))
        data += table + bytes(-len(table) % 4)
    return directory + data


def common_tables(glyphs, maxp):
    head = u32(0x10000, 0x10000, 0, 0x5F0F3CF5) + u16(0, EM) + bytes(16) + u16(0, 0, 600, 900, 0, 8, 2, 1, 0)
    hhea = u32(0x10000) + u16(800, -200, 0, ADVANCE, 0, 0, 600, 1, 0, 0, 0, 0, 0, 0, 0, glyphs)
    return {"head": head, "hhea": hhea, "hmtx": u16(ADVANCE, 0) * glyphs, "maxp": maxp, "cmap": cmap(glyphs)}


def cmap(glyphs):
    """Format 4: A, B and Ä are the glyphs 1, 2 and 3."""
    codes = [0x41, 0x42, 0xC4][:glyphs - 1]
    count = len(codes) + 1
    segments = u16(*codes, 0xFFFF) + u16(0) + u16(*codes, 0xFFFF)
    deltas = u16(*(glyph - code for glyph, code in enumerate(codes, 1)), 1) + u16(*[0] * count)
    body = u16(2 * count, 4, 1, 0) + segments + deltas
    return u16(0, 1, 3, 1) + u32(12) + u16(4, 6 + len(body), 0) + body


def true_type_glyph(contours, has_curves):
    points = [point for contour in contours for point in contour]
    ends, steps, last = [], [[], []], (0, 0)
    for contour in contours:
        ends.append(len(contour) + (ends[-1] + 1 if ends else 0) - 1)
    for point in points:
        for axis in (0, 1):
            steps[axis].append(point[axis] - last[axis])
        last = point
    flags = bytes(0 if has_curves and index >= 2 else 1 for index in range(len(points)))
    box = [pick(point[axis] for point in points) for pick in (min, max) for axis in (0, 1)]
    glyph = u16(len(contours), *box, *ends, 0) + flags + u16(*steps[0]) + u16(*steps[1])
    return glyph + bytes(-len(glyph) % 4)


def true_type():
    composite = u16(-1, 0, 0, 600, 900, 0x0023, 1, 0, 0, 0x000B, 2, 0, 600) + u16(0x2000) + bytes(2)
    glyphs = [b"", true_type_glyph(A, False), true_type_glyph(B, True), composite]
    offsets = [sum(map(len, glyphs[:index])) for index in range(5)]
    tables = common_tables(4, u32(0x10000) + u16(4, 6, 2, 10, 3, 1, 0, 0, 0, 0, 0, 0, 2, 1))
    tables["head"] = tables["head"][:-4] + u16(1, 0)  # long offsets
    kern = u16(0, 1, 0, 20, 1, 1, 6, 0, 0, 1, 2, -50)
    return sfnt(u32(0x10000), tables | {"glyf": b"".join(glyphs), "loca": u32(*offsets), "kern": kern})


def cff_number(value):
    return b"\x1c" + u16(value)


def cff_index(entries):
    if not entries:
        return u16(0)
    offsets = [1 + sum(map(len, entries[:index])) for index in range(len(entries) + 1)]
    return u16(len(entries)) + b"\x02" + u16(*offsets) + b"".join(entries)


def steps_of(contours):
    last = (0, 0)
    for contour in contours:
        for index, point in enumerate(contour):
            yield index == 0, point[0] - last[0], point[1] - last[1]
            last = point


def cff_glyph(contours):
    """rmoveto and rlineto; the first number is the width."""
    moves = [cff_number(x) + cff_number(y) + (b"\x15" if is_first else b"\x05") for is_first, x, y in steps_of(contours)]
    return cff_number(ADVANCE) + b"".join(moves) + b"\x0e"


def open_type():
    name, strings, subroutines = cff_index([b"Seed"]), cff_index([]), cff_index([])
    glyphs = cff_index([cff_number(ADVANCE) + b"\x0e", cff_glyph(A), cff_glyph(B)])
    charset = b"\0" + u16(34, 35)
    top_bytes = len(cff_index([cff_number(0) + b"\x0f" + cff_number(0) + b"\x11"]))
    at = 4 + len(name) + top_bytes + len(strings) + len(subroutines)
    top = cff_index([cff_number(at) + b"\x0f" + cff_number(at + len(charset)) + b"\x11"])
    tables = common_tables(3, u32(0x5000) + u16(3))
    return sfnt(b"OTTO", tables | {"CFF ": b"\x01\0\x04\x02" + name + top + strings + subroutines + charset + glyphs})


def encrypted(plain, key):
    """As Type 1 hides its outlines."""
    cipher = bytearray()
    for byte in bytes(4) + plain:
        cipher.append(byte ^ key >> 8)
        key = (cipher[-1] + key) * 52845 + 22719 & 0xFFFF
    return bytes(cipher)


def type1_number(value):
    return b"\xff" + struct.pack(">i", value)


def type1_glyph(contours):
    moves = [type1_number(x) + type1_number(y) + (b"\x15" if is_first else b"\x05") for is_first, x, y in steps_of(contours)]
    return type1_number(0) + type1_number(ADVANCE) + b"\x0d" + b"".join(moves) + b"\x09\x0e"


def type1(unit):
    """`unit`: what a unit is of an em."""
    glyphs = {"A": encrypted(type1_glyph(A), 4330), "B": encrypted(type1_glyph(B), 4330),
              ".notdef": encrypted(type1_glyph([]), 4330)}
    strings = b"".join(f"/{name} {len(glyph)} RD ".encode() + glyph + b" ND\n" for name, glyph in glyphs.items())
    private = (b"dup /Private 5 dict dup begin\n/RD {string currentfile exch readstring pop} executeonly def\n"
               b"/ND {noaccess def} executeonly def\n/lenIV 4 def\n"
               b"2 index /CharStrings 3 dict dup begin\n" + strings + b"end\nend\nreadonly put\nmark currentfile closefile\n")
    clear = ("%!PS-AdobeFont-1.0: Seed 1\n6 dict begin\n/FontName /Seed def\n/FontType 1 def\n/PaintType 0 def\n"
             f"/FontMatrix [{unit} 0 0 {unit} 0 0] def\n/Encoding StandardEncoding def\n/FontBBox {{0 0 600 900}} def\n"
             "currentdict end\ncurrentfile eexec\n").encode()
    return clear + encrypted(private, 55665) + b"\n" + b"0" * 64 + b"\ncleartomark\n"


BITMAP = b"""STARTFONT 2.1
FONT seed
SIZE 8 75 75
FONTBOUNDINGBOX 8 8 0 0
CHARS 1
STARTCHAR A
ENCODING 65
SWIDTH 500 0
DWIDTH 8 0
BBX 8 1 0 0
BITMAP
FF
ENDCHAR
ENDFONT
"""


def fonts():
    return {"letters.ttf": true_type(), "letters.otf": open_type(), "letters.pfa": type1("0.001"),
            "coarse.pfa": type1("0.01"), "pixels.bdf": BITMAP, "cut.ttf": true_type()[:200]}


def main(folder):
    for name, font in fonts().items():
        (folder / name).write_bytes(font)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "corpus/font")
