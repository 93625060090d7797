"""Reads what a board says on its display in the letters of firmware/run/small_font.hpp."""

import pathlib
import re

FONT = pathlib.Path(__file__).resolve().parents[2] / "firmware/run/small_font.hpp"
WHITE = (255, 255, 255)
LETTER_WIDTH, LETTER_HEIGHT, ADVANCE = 3, 5, 4
MOST_LETTERS = 60


def _font():
    """Letters by their blocks, from the header's tables."""
    text = FONT.read_text(encoding="utf-8")
    def table(name):
        return re.findall(r"0\d{5}", text.split(f"> {name}{{")[1].split("};")[0])
    letters = dict(zip(table("capitals"), "ABCDEFGHIJKLMNOPQRSTUVWXYZ")) | dict(zip(table("digits"), "0123456789"))
    letters |= {blocks: sign for sign, blocks in re.findall(r"case '(.)':[^\n]*\n\s*return (0\d{5});", text)}
    return {int(blocks, 8): sign for blocks, sign in letters.items()} | {0: " "}


def lines_on(picture):
    """The lines of white text in an RGB picture, each in the middle of its width; its outermost pixels do not count."""
    width, height = picture.size
    lit = [[1 <= x < width - 1 and picture.getpixel((x, y)) == WHITE for x in range(width)] for y in range(height)]
    bands, top = [], None
    for y in range(1, height):
        if any(lit[y]) and y < height - 1:
            top = y if top is None else top
        elif top is not None:
            bands.append((top, y))
            top = None
    return [_line(lit, *band) for band in bands]


def _line(lit, top, bottom):
    scale = (bottom - top) // LETTER_HEIGHT
    font = _font()
    for count in range(1, MOST_LETTERS):
        left = (len(lit[0]) - (count * ADVANCE - 1) * scale) // 2
        signs = [font.get(_blocks(lit, left + i * ADVANCE * scale, top, scale)) for i in range(count)]
        if left >= 0 and None not in signs and not any(lit[top + scale // 2][:left]) and signs[0] != " " != signs[-1]:
            return "".join(signs)
    return None


def _blocks(lit, left, top, scale):
    value = 0
    for row in range(LETTER_HEIGHT):
        for column in range(LETTER_WIDTH):
            x, y = left + column * scale + scale // 2, top + row * scale + scale // 2
            value = value << 1 | (0 <= x < len(lit[0]) and lit[y][x])
    return value
