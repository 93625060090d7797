"""The launcher of the portable tar, with a loader that is a script: portable_launcher_test.py <kfast_launcher>."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

LAUNCHER = pathlib.Path(sys.argv.pop(1)).resolve()
LOADER = """#!/bin/sh
for word in "$@"; do echo "$word"; done
env | sed 's/^/env /'
exit 7
"""


class Launcher(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name).resolve()
        self.prefix = self.folder / "a folder"
        (self.prefix / "bin").mkdir(parents=True)
        (self.prefix / "lib/kfast").mkdir(parents=True)
        self.launcher = self.prefix / "bin/kfast"
        shutil.copy(LAUNCHER, self.launcher)
        self.loader = self.prefix / "lib/kfast/ld.so"
        self.loader.write_text(LOADER, encoding="utf-8")
        self.loader.chmod(0o755)

    def run_it(self, program, *arguments, **more):
        return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=60, **more)

    def expect_started(self, result, *arguments):
        words = [line for line in result.stdout.splitlines() if not line.startswith("env ")]
        library = self.prefix / "lib/kfast"
        self.assertEqual(["--inhibit-cache", "--library-path", str(library), "--argv0", str(self.launcher),
                          str(library / "kfast"), *arguments], words)
        self.assertEqual(7, result.returncode)

    def test_gives_the_loader_the_program_with_all_arguments(self):
        self.expect_started(self.run_it(self.launcher, "render", "", "a b", "--help"), "render", "", "a b", "--help")
        self.expect_started(self.run_it(self.launcher))

    def test_finds_its_folder_through_links_and_path(self):
        (self.prefix / "kfast").symlink_to("bin/kfast")
        (self.folder / "kfast").symlink_to(self.prefix / "kfast")
        self.expect_started(self.run_it("./kfast", "new", cwd=self.folder), "new")
        self.expect_started(self.run_it("kfast", env={"PATH": f"{self.folder}:{os.environ['PATH']}"}))

    def test_leaves_the_environment_as_it_is(self):
        result = self.run_it(self.launcher, env={"PATH": os.environ["PATH"], "LAMP": "lit"})
        environment = {line.split("=")[0] for line in result.stdout.splitlines() if line.startswith("env ")}
        self.assertEqual({"env PATH", "env LAMP", "env PWD"}, environment | {"env PWD"})

    def test_alone_it_says_what_is_missing(self):
        self.loader.unlink()
        result = self.run_it(self.launcher)
        self.assertEqual(127, result.returncode)
        self.assertIn(f"{self.loader} cannot be started: No such file", result.stderr)
        self.assertIn("unpack the whole tar", result.stderr)

    def test_needs_no_library(self):
        self.assertNotIn("NEEDED", self.run_it("readelf", "--dynamic", LAUNCHER).stdout)
        self.assertNotIn("INTERP", self.run_it("readelf", "--program-headers", LAUNCHER).stdout)


if __name__ == "__main__":
    unittest.main()
