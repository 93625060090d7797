"""Scenes as source: export_test.py <kfast> <C compiler> <C++ compiler>."""

import json
import re
import subprocess
import sys
import unittest

COMPILERS = {"cpp": sys.argv.pop(), "c": sys.argv.pop()}
from command_case import ROOT, CommandTest

PROGRAM = """#include "{header}"
#include <stdio.h>
int main(void)
{{
    unsigned i;
    printf("%d %d %d", {name}_width, {name}_height, {name}_block_bytes);
    for (i = 0; i < {name}_bytes; ++i)
        printf(" %d", {name}[i]);
    return 0;
}}
"""


class ExportTest(CommandTest):
    def numbers(self, header, name, language, standard):
        """What a program prints that includes the header twice."""
        (self.folder / f"main.{language}").write_text(f'#include "{header}"\n' + PROGRAM.format(header=header, name=name))
        subprocess.run([COMPILERS[language], f"-std={standard}", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion",
                        "-Wshadow", "-Werror", f"main.{language}", "-o", "main"], cwd=self.folder, check=True, timeout=120)
        printed = subprocess.run([self.folder / "main"], check=True, stdout=subprocess.PIPE, text=True, timeout=60)
        return [int(number) for number in printed.stdout.split()]

    def test_the_array_is_the_compiled_scene_in_c_and_in_cpp(self):
        scene = list(self.compiled())
        self.run_kfast("export", "--header", "repeat.kfast")
        for language, standard in (("c", "c99"), ("c", "c17"), ("cpp", "c++11"), ("cpp", "c++20")):
            with self.subTest(standard=standard):
                width, height, block, *array = self.numbers("repeat.h", "repeat", language, standard)
                self.assertEqual(array, scene)
                self.assertEqual((width, height), (60, 40))
                self.assertGreater(block, 0)

    def test_what_it_needs_of_the_player_is_a_macro(self):
        (self.folder / "strokes.kfast").write_text("kfast 1\ncanvas 9 9\nobject a stroke=red { line 1 1 5 5; "
                                                   "key 0 rotate-y=0; key 1 rotate-y=9 }\n")
        self.run_kfast("export", "--header", "strokes.kfast")
        self.assertIn("#define STROKES_FEATURES {&kfast_strokes, 0, 0, 0, &kfast_depth, 0, 0, 0, 0, 0, 0, 0}\n",
                      (self.folder / "strokes.h").read_text())
        self.assertEqual(json.loads(self.run_kfast("info", "strokes.kfast", "--json").stdout)["features"], ["strokes", "depth"])
        self.assertIn("  features    strokes, depth\n", self.run_kfast("info", "strokes.kfast").stdout)
        program = """#include "strokes.h"
#include <library/kfast.h>
static const kfast_features features = STROKES_FEATURES;
int main(void) { return features.strokes == &kfast_strokes && features.depth == &kfast_depth && features.bones == 0 ? 0 : 1; }
"""
        for language, standard in (("c", "c99"), ("cpp", "c++11")):
            (self.folder / f"main.{language}").write_text(program)
            subprocess.run([COMPILERS[language], f"-std={standard}", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-I", ROOT, "-c",
                            f"main.{language}", "-o", "main.o"], cwd=self.folder, check=True, timeout=120)

    def test_memory_is_told_for_the_panel(self):
        def block(*arguments):
            told = self.run_kfast("export", "--header", "repeat.kfast", "-o", "a.h", *arguments).stdout
            figures = figures_of_header()
            self.assertIn("{2} bytes to be lent at {0}x{1}, the player included".format(*figures), told)
            return figures

        def figures_of_header():
            return tuple(int(n) for n in re.findall(r"a_(?:width|height|block_bytes) = (\d+)",
                                                    (self.folder / "a.h").read_text().replace("repeat_", "a_")))

        width, height, small = block()
        self.assertEqual((width, height), (60, 40))
        self.assertEqual(block("--size", "400x300")[:2], (400, 300))
        self.assertGreater(block("--size", "400x300")[2], small)
        self.assertEqual(block("--panel", "ssd0323")[:2], (128, 64))

    def test_the_same_from_the_text_and_from_the_compiled_scene(self):
        self.compiled()
        self.run_kfast("export", "--header", "repeat.kfb", "-o", "a.h")
        self.run_kfast("export", "--header", "repeat.kfast", "-o", "b.h")
        self.assertEqual((self.folder / "a.h").read_text().replace("repeat.kfb", "repeat.kfast"),
                         (self.folder / "b.h").read_text())

    def test_names(self):
        for file, name in (("robot-eyes", "robot_eyes"), ("a.b c", "a_b_c"), ("_x_", "x"), ("Größe", "Gr_e")):
            (self.folder / f"{file}.kfast").write_text((self.folder / "once.kfast").read_text())
            self.run_kfast("export", "--header", f"{file}.kfast")
            self.assertIn(f"unsigned char {name}[", (self.folder / f"{file}.h").read_text())
        self.run_kfast("export", "--header", "once.kfast", "--array-name", "Blink2_a", "-o", "a.h")
        self.assertIn("unsigned char Blink2_a[Blink2_a_bytes]", (self.folder / "a.h").read_text())
        self.assertIn("#ifndef KFAST_SCENE_BLINK2_A_H\n", (self.folder / "a.h").read_text())

    def test_names_that_are_none(self):
        for name in ("", "2048", "a-b", "a b", "größe", "_a", "a_", "a__b", "int", "class", "main", "kfast", "kfast_show",
                     "a" * 49):
            with self.subTest(name=name):
                self.refuse("export", "--header", "once.kfast", f"--array-name={name}", status=2, says="--array-name")
        for file in ("2048", "int", "ü"):
            (self.folder / f"{file}.kfast").write_text((self.folder / "once.kfast").read_text())
            self.refuse("export", "--header", f"{file}.kfast", status=1, says="choose one with --array-name")

    def test_a_file_name_does_not_end_the_comment(self):
        name = "*\n#error.kfast"
        (self.folder / name).write_text((self.folder / "once.kfast").read_text())
        self.run_kfast("export", "--header", name, "--array-name", "a", "-o", "a.h")
        self.assertEqual(len(self.numbers("a.h", "a", "c", "c99")) - 3, len(self.compiled()))

    def test_wrong_usage(self):
        self.refuse("export", "once.kfast", status=2, says="choose one of --header, --ild, --wav")
        self.refuse("export", "--header", status=2, says="FILE is required")
        self.refuse("export", "--header", "once.kfast", "-o", "once.kfast", status=1, says="overwrite the scene")
        self.refuse("export", "--header", "once.kfast", "-o", "none/a.h", status=1, says="create the folder first")
        self.refuse("export", "--header", "none.kfast", status=1, says="none.kfast")

    def test_a_full_disk_leaves_what_was_there(self):
        (self.folder / "a.h").write_text("before")
        self.refuse("export", "--header", "once.kfast", "-o", "a.h", status=1, says="a.h", limit=100)
        self.assertEqual((self.folder / "a.h").read_text(), "before")

    def test_the_header_of_the_library_examples_is_up_to_date(self):
        self.run_kfast("export", "--header", ROOT / "examples/robot-eyes.kfast", "-o", "a.h")
        self.assertEqual((self.folder / "a.h").read_text(), (ROOT / "examples/library/robot_eyes.h").read_text(),
                         "write it again: kfast export --header examples/robot-eyes.kfast -o examples/library/robot_eyes.h")


if __name__ == "__main__":
    unittest.main()
