"""Shows that layering.py finds what it is there to find."""

import pathlib
import tempfile
import unittest

from layering import check


DESIGN = """
| room | is | may include |
|---|---|---|
| `core` | doors | `core/low`, `core/own.hpp` |
| `core/low` | the ground | |
| `core/own.hpp` | a header that is a room of its own | `core/low` |

Others:

| room | is | may include |
|---|---|---|
| `firmware` | the loop | `core/` |
| `library` | for programs | `core` |
| `boards/x` | a board | `firmware` |

| room of `host/` | is | may include |
|---|---|---|
| `.` | main | `a/` |
| `a` | a folder | `firmware`, `a/b` |
| `a/b` | and a room in it | |
| `svg` | a reader | |
| `svg/style` | and a room in it | |
"""

# What every room has, so that nothing in the tables is in vain.
FILES = {
    "core/a.hpp": '#include "core/low/b.hpp"\n#include "core/own.hpp"\n#include <array>\n',
    "core/low/b.hpp": "",
    "core/own.hpp": '#include "core/low/b.hpp"\n',
    "firmware/a.hpp": '#include "core/low/b.hpp"\n#include <span>\n',
    "library/a.h": "#include <stddef.h>\n",
    "library/a.cpp": '#include "library/a.h"\n#include "core/a.hpp"\n#include <new>\n',
    "boards/x/a.cpp": '#include "firmware/a.hpp"\n#include <atomic>\n',
    "host/main.cpp": '#include "host/a/a.hpp"\n#include <vector>\n',
    "host/a/a.hpp": '#include "firmware/a.hpp"\n#include "host/a/b/b.hpp"\n',
    "host/a/b/b.hpp": "",
    "host/svg/b.cpp": "#include <pugixml.hpp>\n",
    "host/svg/style/b.cpp": "#include <pugixml.hpp>\n",
    "examples/library/a.c": '#include "a.h"\n#include <stdio.h>\n',
    "examples/library/a.cpp": '#include "core/a.hpp"\n#include <vector>\n',
    "tests/a.cpp": '#include "host/a/a.hpp"\n#include "boards/x/a.hpp"\n',
}


class Layering(unittest.TestCase):
    def mistakes(self, files, design=DESIGN):
        """Of FILES with `files` besides or in their places."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {**FILES, **files, "docs/design.md": design}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return check(root)

    def test_accepts_what_is_allowed(self):
        self.assertEqual([], self.mistakes({}))

    def test_refuses_what_the_tables_do_not_name(self):
        for place, included in [("core/b.hpp", "firmware/a.hpp"), ("core/low/c.hpp", "core/a.hpp"),
                                ("core/low/c.cpp", "core/own.hpp"), ("firmware/b.cpp", "host/a/a.hpp"),
                                ("boards/x/b.cpp", "core/a.hpp"), ("host/a/b/c.cpp", "host/a/a.hpp"), ("host/b.cpp", "core/a.hpp"),
                                ("host/a/c.cpp", "boards/x/a.hpp"), ("host/a/c.cpp", "host/none/a.hpp"),
                                ("examples/b.cpp", "host/a/a.hpp"), ("host/b.cpp", "tests/b.hpp"), ("library/b.cpp", "firmware/a.hpp")]:
            with self.subTest(place=place, included=included):
                found = self.mistakes({place: f'#include "{included}"\n'})
                self.assertEqual(1, len(found), found)
                self.assertIn(f"{place}: {included} reaches", found[0])

    def test_refuses_what_lies_in_no_room(self):
        self.assertEqual(["host/c/a.cpp: is in no room of docs/design.md"], self.mistakes({"host/c/a.cpp": ""}))

    def test_refuses_words_of_the_tables_that_nothing_needs(self):
        self.assertEqual(["docs/design.md: core/low may include core, and does not",
                          "docs/design.md: rooms include each other: core > core/low > core"],
                         self.mistakes({}, DESIGN.replace("the ground | |", "the ground | `core` |")))
        self.assertEqual(["docs/design.md: host/none has no files"],
                         self.mistakes({}, DESIGN + "| `none` | nothing | |\n"))

    def test_refuses_rows_that_are_wrong(self):
        self.assertEqual(["docs/design.md: core/low stands in two rows"],
                         self.mistakes({}, DESIGN.replace("| `core/own.hpp` |", "| `core/low` | again | |\n| `core/own.hpp` |")))
        self.assertEqual(["docs/design.md: not three cells: | `none` | nothing |"],
                         self.mistakes({}, DESIGN + "| `none` | nothing |\n"))

    def test_refuses_own_headers_in_angle_brackets(self):
        self.assertIn("belongs into quotes", self.mistakes({"host/b.cpp": "#include <core/a.hpp>\n"})[0])

    def test_refuses_rooms_that_are_too_full(self):
        for folder, most in [("core/low", 40), ("host/a/b", 60)]:
            names = [f"{folder}/{number}.hpp" for number in range(most - 1)]
            self.assertEqual([], self.mistakes(dict.fromkeys(names, "")))
            self.assertEqual([f"{folder}: has {most + 1} files, more than {most}"],
                             self.mistakes(dict.fromkeys([*names, f"{folder}/more.hpp"], "")))

    def test_refuses_relative_includes(self):
        self.assertIn("climbs", self.mistakes({"core/b.hpp": '#include "../core/low/b.hpp"\n'})[0])
        self.assertIn("from the root", self.mistakes({"core/b.hpp": '#  include "b.hpp"\n'})[0])

    def test_refuses_hosted_headers_on_the_device(self):
        for folder in ["core", "firmware", "library"]:
            for header in ["vector", "string", "cstdio", "math.h"]:
                with self.subTest(folder=folder, header=header):
                    self.assertEqual(1, len(self.mistakes({f"{folder}/b.hpp": f"#include <{header}>\n"})))

    def test_refuses_a_library_that_is_not_hidden(self):
        for header in ["sndfile.h", "hidapi/hidapi.h", "libusb-1.0/libusb.h", "gpiod.h", "zip.h", "zlib.h"]:
            with self.subTest(header=header):
                line = f"#include <{header}>\n"
                self.assertEqual([], self.mistakes({"host/a.cpp": line}))
                self.assertEqual(1, len(self.mistakes({"host/a.hpp": line})))
                self.assertEqual(1, len(self.mistakes({"host/a.cpp": line, "host/b.cpp": line})))
                self.assertEqual([], self.mistakes({"host/a.cpp": line, "tests/b.cpp": line}))
                self.assertEqual([], self.mistakes({"host/a_v1.cpp": line, "host/a_v2.cpp": line}))
                self.assertEqual(1, len(self.mistakes({"host/a_v1.cpp": line, "host/b_v2.cpp": line})))

    def test_freetype_is_hidden_by_two_files(self):
        for header in ("freetype/freetype.h", "ft2build.h"):
            files = {f"host/{name}.cpp": f"#include <{header}>\n" for name in "ab"}
            self.assertEqual([], self.mistakes(files))
            self.assertEqual(1, len(self.mistakes({**files, "host/d.cpp": f"#include <{header}>\n"})))

    def test_keeps_pugixml_in_a_few_folders(self):
        line = "#include <pugixml.hpp>\n"
        self.assertEqual([], self.mistakes({"host/svg/a.hpp": line, "host/svg/b.cpp": line, "tests/a.cpp": line}))
        self.assertIn("pugixml", self.mistakes({"host/a.cpp": line})[0])
        self.assertEqual(1, len(self.mistakes({"core/a.cpp": line})))

    def test_lets_two_files_hide_sdl(self):
        line = "#include <SDL2/SDL.h>\n"
        self.assertEqual([], self.mistakes({"host/a.cpp": line, "host/b.cpp": line}))
        self.assertEqual(1, len(self.mistakes({"host/a.cpp": line, "host/b.cpp": line, "host/c.cpp": line})))
        self.assertEqual(1, len(self.mistakes({"host/a.hpp": line})))


if __name__ == "__main__":
    unittest.main()
