"""The packages that cpack makes: debian_test.py <CPackConfig.cmake>."""

import gzip
import os
import pathlib
import re
import stat
import subprocess
import sys
import tempfile
import unittest

CONFIG = sys.argv.pop(1)


def output_of(*command, **more):
    return subprocess.run([*map(str, command)], check=True, stdout=subprocess.PIPE, text=True, timeout=300, **more).stdout


def packages_in(folder):
    output_of("cpack", "--config", CONFIG, "-B", folder, env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"})
    return {path.name.split("_")[0]: path for path in folder.glob("*.deb")}


class Debian(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        cls.packages = packages_in(cls.folder / "first")

    def unpacked(self, name):
        root = pathlib.Path(tempfile.mkdtemp(dir=self.folder)) / name
        output_of("dpkg-deb", "--raw-extract", self.packages[name], root)
        return root

    def field(self, name, field):
        return output_of("dpkg-deb", "--field", self.packages[name], field).strip()

    def test_there_are_two(self):
        self.assertEqual({"kfast", "libkfast-dev"}, set(self.packages))

    def test_the_command_runs_from_its_unpacked_root_and_has_its_firmware(self):
        root = self.unpacked("kfast")
        scene = self.folder / "eyes.kfast"
        output_of(root / "usr/bin/kfast", "new", scene)
        output_of(root / "usr/bin/kfast", "compile", scene)
        for bus in "spi", "i2c", "parallel", "xy":
            self.assertTrue((root / f"usr/share/kfast/firmware/pico-{bus}.bin").is_file())
        self.assertTrue((root / "usr/lib/udev/rules.d/70-kfast.rules").is_file())
        self.assertTrue((root / "usr/share/doc/kfast/copyright").is_file())
        self.assertTrue((root / "usr/share/doc/kfast/changelog.gz").is_file())
        self.assertFalse((root / "usr/include").exists())

    def test_their_changelogs_are_debians_and_name_the_maintainer(self):
        for name in self.packages:
            log = self.unpacked(name) / f"usr/share/doc/{name}/changelog.gz"
            read = subprocess.run(["dpkg-parsechangelog", "-l", "-"], input=gzip.decompress(log.read_bytes()), capture_output=True,
                                  check=True, timeout=60)
            self.assertEqual(b"", read.stderr)
            fields = dict(line.split(": ", 1) for line in read.stdout.decode().splitlines() if re.match(r"\w+: ", line))
            self.assertEqual([name, self.field(name, "Version")], [fields["Source"], fields["Version"]])
            self.assertRegex(fields["Maintainer"], r"^[^<>]+ <[^@\s<>]+@[^@\s<>]+\.[^@\s<>]+>$")
            self.assertEqual(self.field(name, "Maintainer"), fields["Maintainer"])

    def test_udev_is_told_of_the_rule_where_there_is_one(self):
        script = self.unpacked("kfast") / "DEBIAN/postinst"
        self.assertTrue(script.stat().st_mode & stat.S_IXUSR)
        told = self.folder / "told"
        (self.folder / "udevadm").write_text(f'#!/bin/sh\necho "$*" >>{told}\nexit 1\n')
        (self.folder / "udevadm").chmod(0o755)
        output_of("/bin/sh", script, "configure", env={"PATH": f"{self.folder}"})
        self.assertEqual(["control --reload", "trigger --subsystem-match=hidraw --subsystem-match=usb"],
                         told.read_text().splitlines())
        output_of("/bin/sh", script, "configure", env={"PATH": "/nowhere"})

    def test_depends_on_the_libraries_that_it_links(self):
        depends = self.field("kfast", "Depends")
        for library in "libc6", "libstdc++6", "libpng16-16", "libusb-1.0-0", "libhidapi-hidraw0":
            self.assertIn(library, depends)

    def test_depends_on_what_is_said_for_other_processors(self):
        """dpkg-shlibdeps says it here, scripts/shared_libraries.py where that cannot."""
        script = pathlib.Path(__file__).resolve().parents[2] / "scripts/shared_libraries.py"
        program = self.unpacked("kfast") / "usr/bin/kfast"
        said = output_of(sys.executable, script, "depends", program, "/").strip()
        packages = [{each.split()[0] for each in depends.split(", ")} for depends in (self.field("kfast", "Depends"), said)]
        self.assertEqual(*packages)

    def test_the_library_needs_nothing_and_brings_no_command(self):
        self.assertEqual("", self.field("libkfast-dev", "Depends"))
        root = self.unpacked("libkfast-dev")
        self.assertTrue((root / "usr/lib/libkfast.a").is_file())
        self.assertTrue((root / "usr/include/kfast/library/kfast.h").is_file())
        self.assertFalse((root / "usr/bin").exists())

    def test_are_the_same_when_made_again(self):
        again = packages_in(self.folder / "second")
        for name, package in self.packages.items():
            self.assertEqual(package.read_bytes(), again[name].read_bytes(), name)


if __name__ == "__main__":
    unittest.main()
