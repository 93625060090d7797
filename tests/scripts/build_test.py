"""scripts/build with a cmake that builds nothing: build_test.py"""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

CMAKE = f"""#!/bin/bash
[ "$1" != --list-presets ] || exec {shutil.which("cmake")} "$@"
echo "cmake $*" >>calls
echo "${{CMAKE_CXX_COMPILER_LAUNCHER-none}}" >launcher
"""


class BuildTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        for folder in ("bin", "scripts"):
            (self.folder / folder).mkdir()
        for name in ("scripts/build", "CMakePresets.json"):
            shutil.copy(ROOT / name, self.folder / name)
        (self.folder / "bin/cmake").write_text(CMAKE, encoding="utf-8")
        (self.folder / "bin/cmake").chmod(0o755)

    def build(self, *arguments, status=0, **environment):
        environment = {**os.environ, "PATH": f"{self.folder / 'bin'}:{os.environ['PATH']}", **environment}
        result = subprocess.run([self.folder / "scripts/build", *arguments], env=environment, capture_output=True, text=True,
                                timeout=60, check=False)
        self.assertEqual(status, result.returncode, result.stdout + result.stderr)
        return result

    def calls(self):
        calls = self.folder / "calls"
        return calls.read_text(encoding="utf-8").splitlines() if calls.exists() else []

    def test_presets_are_built_in_their_order(self):
        self.build("pico", "command")
        self.assertEqual(["cmake --preset pico", "cmake --build --preset pico", "cmake --preset command",
                          "cmake --build --preset command"], self.calls())

    def test_ccache_starts_the_compilers_where_it_is_installed(self):
        (self.folder / "bin/ccache").write_text("#!/bin/sh\n", encoding="utf-8")
        (self.folder / "bin/ccache").chmod(0o755)
        os.environ.pop("CMAKE_CXX_COMPILER_LAUNCHER", None)
        for environment, launcher in (({}, "ccache"), ({"CMAKE_CXX_COMPILER_LAUNCHER": "distcc"}, "distcc"),
                                      ({"CMAKE_CXX_COMPILER_LAUNCHER": ""}, "")):
            with self.subTest(environment):
                self.build("pico", **environment)
                self.assertEqual(f"{launcher}\n", (self.folder / "launcher").read_text(encoding="utf-8"))

    def test_help_lists_the_presets_and_what_they_are_for(self):
        printed = self.build("--help").stdout
        self.assertTrue(printed.startswith("usage: scripts/build PRESET..., of:\n"), printed)
        self.assertRegex(printed, "(?m)^  command  .* for its users")
        self.assertRegex(printed, "(?m)^  pico  .*RP2040")
        self.assertNotIn("Available", printed)
        self.assertEqual([], self.calls())

    def test_wrong_usage_builds_nothing(self):
        for arguments in ([], ["--quick"], ["pico", "comand"], [""], ["base"]):
            with self.subTest(arguments):
                result = self.build(*arguments, status=2)
                self.assertIn("usage: scripts/build", result.stderr)
                self.assertEqual(([], ""), (self.calls(), result.stdout))
        self.assertIn("There is no preset 'comand'.", self.build("comand", status=2).stderr)


if __name__ == "__main__":
    unittest.main()
