"""cmake --install, into a prefix that is moved afterwards: install_test.py <build folder> <where it is left>."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

LEFT = pathlib.Path(sys.argv.pop(2))
BUILD = sys.argv.pop(1)

WANTED = """
    bin/kfast lib/udev/rules.d/70-kfast.rules
    share/kfast/firmware/pico-spi.bin share/kfast/firmware/pico-i2c.bin share/kfast/firmware/pico-parallel.bin
    share/kfast/firmware/pico-xy.bin share/kfast/firmware/pico-spi.uf2
    share/doc/kfast/README.md share/doc/kfast/CHANGELOG.md share/doc/kfast/NOTICE share/doc/kfast/docs/library.md
    share/doc/kfast/examples/robot-eyes.kfast share/doc/kfast/examples/library/CMakeLists.txt
    share/man/man1/kfast.1.gz share/bash-completion/completions/kfast share/zsh/site-functions/_kfast
    share/fish/vendor_completions.d/kfast.fish share/kfast/editors/vscode/package.json
    include/kfast/library/kfast.h include/kfast/library/kfast.hpp include/kfast/library/kfast_player.hpp
    include/kfast/core/pose/equalize.hpp include/kfast/core/beam/beam_player.hpp
    lib/libkfast.a lib/libkfast_core.a lib/cmake/kfast/kfast-config.cmake lib/pkgconfig/kfast.pc
""".split()


def install(*arguments, **environment):
    subprocess.run(["cmake", "--install", BUILD, *map(str, arguments)], env={**os.environ, **environment}, check=True,
                   stdout=subprocess.DEVNULL, timeout=120)


def files_below(folder):
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}


class Install(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def test_has_all_that_belongs_to_it_and_works_after_a_move(self):
        first = self.folder / "first"
        install("--prefix", first)
        self.assertEqual([], [name for name in WANTED if name not in files_below(first)])
        shutil.rmtree(LEFT, ignore_errors=True)
        shutil.move(first, LEFT)
        scene = self.folder / "eyes.kfast"
        subprocess.run([LEFT / "bin/kfast", "new", scene], stdout=subprocess.DEVNULL, check=True, timeout=60)
        subprocess.run([LEFT / "bin/kfast", "compile", scene], stdout=subprocess.DEVNULL, check=True, timeout=60)
        for path in (LEFT / "lib/cmake/kfast").iterdir():
            self.assertNotIn(str(first), path.read_text(), path.name)

    def test_heeds_destdir(self):
        install("--prefix", "/opt/kfast", DESTDIR=str(self.folder))
        self.assertEqual([], [name for name in WANTED if name not in files_below(self.folder / "opt/kfast")])

    def test_is_split_into_the_command_and_the_library(self):
        install("--prefix", self.folder, "--component", "development")
        names = files_below(self.folder)
        self.assertIn("lib/libkfast.a", names)
        self.assertFalse({name for name in names if name.startswith(("bin", "share/kfast"))})


if __name__ == "__main__":
    unittest.main()
