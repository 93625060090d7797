"""Shows that layering.py finds what it is there to find."""

import pathlib
import tempfile
import unittest

from layering import check


class Layering(unittest.TestCase):
    def mistakes(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return check(root)

    def test_accepts_what_is_allowed(self):
        self.assertEqual([], self.mistakes({
            "core/a.hpp": '#include "core/b.hpp"\n#include <array>\n',
            "firmware/a.hpp": '#include "core/b.hpp"\n#include <span>\n',
            "boards/x/a.cpp": '#include "firmware/a.hpp"\n#include <atomic>\n',
            "host/a.cpp": '#include "firmware/a.hpp"\n#include <vector>\n#include <SDL2/SDL.h>\n',
            "library/a.h": "#include <stddef.h>\n",
            "library/a.cpp": '#include "library/a.h"\n#include "core/b.hpp"\n#include <new>\n',
            "examples/library/a.c": '#include "a.h"\n#include <stdio.h>\n',
            "examples/library/a.cpp": '#include "core/b.hpp"\n#include <vector>\n',
            "tests/a.cpp": '#include "host/a.hpp"\n#include "boards/x/a.hpp"\n',
        }))

    def test_refuses_an_upward_include(self):
        for place, included in [("core/a.hpp", "firmware/b.hpp"), ("firmware/a.hpp", "boards/x/b.hpp"),
                                ("firmware/a.cpp", "host/b.hpp"), ("boards/x/a.cpp", "host/b.hpp"),
                                ("host/a.cpp", "boards/x/b.hpp"), ("examples/a.cpp", "host/b.hpp"), ("host/a.cpp", "tests/b.hpp"),
                                ("core/a.cpp", "library/b.hpp"), ("library/a.cpp", "firmware/b.hpp")]:
            with self.subTest(place=place):
                found = self.mistakes({place: f'#include "{included}"\n'})
                self.assertEqual(1, len(found))
                self.assertIn(f"{place}: {included} reaches", found[0])

    def test_refuses_relative_includes(self):
        self.assertIn("climbs", self.mistakes({"core/a.hpp": '#include "../core/b.hpp"\n'})[0])
        self.assertIn("from the root", self.mistakes({"core/a.hpp": '#  include "b.hpp"\n'})[0])

    def test_refuses_hosted_headers_on_the_device(self):
        for folder in ["core", "firmware", "library"]:
            for header in ["vector", "string", "cstdio", "math.h"]:
                with self.subTest(folder=folder, header=header):
                    self.assertEqual(1, len(self.mistakes({f"{folder}/a.hpp": f"#include <{header}>\n"})))

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

    def test_freetype_is_hidden_by_three_files(self):
        for header in ("freetype/freetype.h", "ft2build.h"):
            files = {f"host/{name}.cpp": f"#include <{header}>\n" for name in "abc"}
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
