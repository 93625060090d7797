"""What scripts/install does about npm, on a machine that has all of Debian's packages: install_test.py"""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

PROGRAMS = {
    "dpkg-query": "printf installed", "node": "exit 0", "npm": 'echo "$@" >>"$CALLS"; {npm}', "apt-cache": "{apt-cache}",
    "id": "echo 0", "apt-get": 'echo apt-get "$@" >>"$CALLS"',
}


class InstallTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        for name in ("scripts/install", "tests/emulation/package.json", "tests/emulation/package-lock.json"):
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, self.folder / name)
        self.modules = self.folder / "tests/emulation/node_modules"

    def install(self, *arguments, npm, apt_cache="exit 0"):
        """The result, and what npm and apt-get were called with."""
        programs = self.folder / "bin"
        programs.mkdir(exist_ok=True)
        for name, text in PROGRAMS.items():
            text = text.replace("{npm}", npm).replace("{apt-cache}", apt_cache)
            (programs / name).write_text(f"#!/bin/sh\n{text}\n")
            (programs / name).chmod(0o755)
        calls = self.folder / "calls"
        calls.write_text("")
        result = subprocess.run([self.folder / "scripts/install", *arguments], capture_output=True, text=True, timeout=60,
                                env={**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "CALLS": str(calls)})
        return result, calls.read_text().splitlines()

    def test_modules_are_installed_once(self):
        for wanted in (["ci --silent"], []):
            result, calls = self.install(npm="mkdir node_modules")
            self.assertEqual((result.returncode, calls), (0, wanted), result.stderr)
        self.assertTrue((self.modules / "package-lock.json").is_file())

    def test_a_failure_of_npm_is_told_in_a_sentence(self):
        result, calls = self.install(npm="exit 7")
        self.assertEqual((result.returncode, calls), (1, ["ci --silent"]))
        self.assertIn("npm could not install rp2040js", result.stderr)
        self.assertIn("scripts/install --without-npm", result.stderr)
        self.assertFalse(self.modules.exists())

    def test_apt_is_told_what_there_is_when_it_does_not_know_the_kernel(self):
        result, calls = self.install(npm="mkdir node_modules", apt_cache="exit 100")
        self.assertEqual((result.returncode, calls), (0, ["apt-get update -qq", "ci --silent"]), result.stderr)

    def test_without_npm(self):
        result, calls = self.install("--without-npm", npm="exit 7", apt_cache="exit 100")
        self.assertEqual((result.returncode, result.stderr, calls), (0, "", []))

    def test_the_demo_needs_no_npm(self):
        self.assertIn("scripts/install --without-npm\n", (ROOT / "scripts/demo").read_text())

    def test_wrong_usage(self):
        result, calls = self.install("--without", npm="exit 0")
        self.assertEqual((result.returncode, calls), (2, []))
        self.assertIn("usage: scripts/install", result.stderr)


if __name__ == "__main__":
    unittest.main()
