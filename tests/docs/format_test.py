"""The bits and limits that docs/format.md tells are those of core/scene/format.hpp and core/scene/kfb_limits.hpp."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAMESPACE = re.compile(r'/// "([^"]+)"[^\n]*\n(?:///[^\n]*\n)*namespace (\w+) \{\n(.*?)\n\}\n', re.DOTALL)
FIELD = re.compile(r"BitField<(\d+), (\d+)(?:, \d+)?> \w+")
FLAG = re.compile(r"BitFlag<(\d+)> \w+")
NUMBER = re.compile(r"inline constexpr [\w:]+ (\w+)\s*=\s*([^;]+);")
BITS = re.compile(r"\bbits? (\d+)(?:–(\d+)|((?:, \d+)*))")

# Records whose bits the page tells in other words.
IN_WORDS = {
    "time_code": "2 × frames, or 2 × ticks + 1",
    "tag": "`4B 46 42` (\"KFB\")",
    "rate": "2 × frames in a second, or 2 × frames in 1000 seconds + 1",
    "law_pair": "the law for x in the low, for y in the high four bits",
    "kerning": "256 × the left glyph + the right one",
    "repeated_form": "3 + 4 if it is mirrored in x, + 8 if in y",
    "segments": "2 × number of segments, + 1 if cubics are predicted",
    "sparse_vector": "two bits come first: whether x and whether y is stored",
}

# What the page says of numbers, without the commas in them.
SENTENCES = [
    ("The compiled scene (.kfb), format version 3", "format version {version}"),
    ("Numbers", "tick | 1/{ticks_per_frame} frame"),
    ("Header", "format version, {version}"),
    ("Header", "outlines of one picture, at most {max_outline_units}"),
    ("Header", "borders of one picture, at most {max_borders}"),
    ("Header", "from picture to picture, at most {max_cache_units}"),
    ("Header", "time code of the length, 1 … {max_frames} frames"),
    ("Header", "1 … {max_frame_rate} frames in 1000 seconds"),
    ("Header", "width and height in pixels, 1 … {max_canvas}"),
    ("Header", "in pixels, {min_camera} … {max_camera}"),
    ("Laws", "{as_for_x} there: the law for y is that for x"),
    ("Inputs", "1 … {max_inputs} of them"),
    ("Numbers #2", "-{max_input_value} … {max_input_value}"),
    ("Texts", "the most characters that it has, 1 … {max_text}"),
    ("Texts", "number of glyphs, n, 1 … {max_glyphs}"),
    ("Drawings from outside", "may be told, 1 … {max_live_points}"),
    ("Marks", "number of clocks, at most {max_clocks}"),
    ("Clocks", "-{max_time} … {max_time} ticks"),
    ("Key times", "t + s at most {max_time_bits}"),
    ("Key times", "number of laws, 0 … {max_law_width}"),
    ("Values", "For u = {degree_unit} numbers are degrees"),
    ("Bones", "number of bones, 1 … {max_bones}; those of all skeletons together at most {max_bones_together}"),
    ("Bones", "{min_coordinate} … {max_coordinate} in 1/16 px"),
    ("Bones", "1 … {max_bone_length} in 1/16 px"),
    ("Bones", "-{max_bone_turn} … {max_bone_turn}"),
    ("Items", "at most {max_depth} deep in each other"),
    ("Items", "has at most {max_items} items"),
    ("Items", "at most {max_paint_steps} steps of painting"),
    ("Items", "there are at most {max_ordered_items}"),
    ("Items", "width in 1/16 px, 1 … {max_width}"),
    ("Items", "in 1/8 widths, at least {min_miter_limit}"),
    ("Live items", "in 1/{advance_one} px"),
    ("Wire frames", "kind 3 with {wire_frame} behind it"),
    ("Skins", "a u16, in 1/{whole_weight}"),
    ("Skins", "a u8, in 1/{coarse_weight}"),
    ("Backbones", "s, {min_unit_bits} … {max_unit_bits}"),
    ("Backbones", "at most {max_backbones} backbones and {max_backbone_segments} segments"),
    ("Tracks", "-{max_turn} … {max_turn}"),
    ("Tracks", "-{max_scale} … {max_scale}"),
    ("Tracks", "{min_hatch_spacing} … {max_width}"),
    ("Tracks", "all together at most {max_path}"),
    ("Forms", "at most {max_drawing_points} points"),
]


def text_of(path):
    return (ROOT / path).read_text(encoding="utf-8")


def sections():
    """The parts of the page by their headings; the second of a name has " #2" behind it."""
    found = {}
    for part in re.split(r"^#+ ", text_of("docs/format.md"), flags=re.MULTILINE)[1:]:
        name, _, text = part.partition("\n")
        found[name if name not in found else name + " #2"] = name + "\n" + " ".join(text.split())
    return found


def numbers():
    """The constants of both headers by their names."""
    found = {}
    for path in ("core/scene/kfb_limits.hpp", "core/scene/format.hpp"):
        for name, value in NUMBER.findall(text_of(path)):
            value = re.sub(r"(?<=[0-9A-F])U", "", value.replace("'", ""))
            if re.fullmatch(r"[\w\s*<+-]+", value) and "K" not in value:
                found[name] = eval(value, {"__builtins__": {}}, dict(found))
    found["ticks_per_frame"] = 1024
    found["max_frames"] = found["max_time"] // 1024
    for kind in ("outline", "cache"):
        found[f"max_{kind}_units"] = found[f"max_{kind}_bytes"] // found["memory_unit"]
    return found


def bits_in(text):
    """Pairs of the first and the last bit of all that a text mentions."""
    found = set()
    for first, last, others in BITS.findall(text):
        found.add((int(first), int(last or first)))
        found.update((int(bit), int(bit)) for bit in re.findall(r"\d+", others))
    return found


def fields_in(body, is_of_bytes):
    """Pairs of the first and the last bit of all fields of a namespace, counted in each byte if the page does so."""
    pairs = [(int(shift), int(shift) + int(width) - 1) for shift, width in FIELD.findall(body)]
    pairs += [(int(bit), int(bit)) for bit in FLAG.findall(body)]
    return {(first % 8, first % 8 + last - first) if is_of_bytes else (first, last) for first, last in pairs}


class Format(unittest.TestCase):
    def setUp(self):
        self.sections = sections()
        self.records = NAMESPACE.findall(text_of("core/scene/format.hpp"))

    def test_each_record_is_read(self):
        self.assertEqual(len(self.records), len(re.findall(r"^namespace \w+ \{", text_of("core/scene/format.hpp"), re.MULTILINE)))

    def test_bits_are_those_of_the_page(self):
        described = {}
        for section, name, body in self.records:
            self.assertIn(section, self.sections, name)
            if name in IN_WORDS:
                self.assertIn(IN_WORDS[name], self.sections[section], name)
            else:
                described.setdefault(section, set()).update(fields_in(body, name == "form"))
        for section, fields in described.items():
            self.assertEqual(fields, bits_in(self.sections[section]), section)

    def test_numbers_are_those_of_the_page(self):
        values = numbers()
        for section, sentence in SENTENCES:
            text = re.sub(r"(?<=\d),(?=\d\d\d)", "", self.sections[section]).replace("−", "-")
            self.assertIn(sentence.format(**values), text)


if __name__ == "__main__":
    unittest.main()
