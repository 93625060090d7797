"""Builds examples of examples/library by what pkg-config says, which draw what those built by find_package draw:
pkg_config_test.py <installed> <folder of those> <c++ compiler>."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

CXX = sys.argv.pop(3)
PROGRAMS = pathlib.Path(sys.argv.pop(2))
INSTALLED = pathlib.Path(sys.argv.pop(1)).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[2]


def output_of(*command, **more):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, timeout=120, **more).stdout


def told(*options):
    environment = {**os.environ, "PKG_CONFIG_PATH": str(INSTALLED / "lib/pkgconfig")}
    return output_of("pkg-config", *options, "kfast", env=environment, text=True).split()


class PkgConfig(unittest.TestCase):
    def check(self, compiler, name):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "program"
            output_of(*compiler, ROOT / "examples/library" / name, *told("--cflags", "--libs"), "-o", program)
            self.assertEqual(output_of(program), output_of(PROGRAMS / pathlib.Path(name).stem))

    def test_builds_a_program_in_cpp(self):
        self.check([CXX, "-std=c++20"], "wink.cpp")

    def test_builds_a_program_in_c_without_the_library_of_cpp(self):
        self.check(["cc", "-std=c99"], "eyes.c")

    def test_builds_a_program_of_the_core_alone(self):
        self.check([CXX, "-std=c++20"], "morph.cpp")

    def test_tells_the_version_of_the_project(self):
        project = json.loads((ROOT / "packages/project.json").read_text(encoding="utf-8"))
        self.assertEqual([project["version"]], told("--modversion"))


if __name__ == "__main__":
    unittest.main()
