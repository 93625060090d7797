"""Where there is no memory the command says so, and leaves everything as it was: one allocation after the other fails.

Goes through a share of them. FAILING_STRIDE=1 goes through all, which takes a quarter of an hour; FAILING_OFFSET is where it begins."""

import os
import resource
import subprocess
import unittest
import zipfile

from failing_case import DRAWING, FILM, FailingTest
from command_case import KFAST

RUNS = 150  # of each command
FOR_THE_LAST_LINE = 20


class MemoryTest(FailingTest):
    def go_through(self, *arguments):
        """The last few are for the line that says what has been written."""
        whole, number = self.whole(arguments, "memory")
        stride = int(os.environ.get("FAILING_STRIDE", 0)) or max(number // RUNS, 1)
        offset = int(os.environ.get("FAILING_OFFSET", 1))
        refused = 0
        for first in range(offset, number + 1, stride):
            refused += self.fails(arguments, first, number, whole).returncode
        self.assertGreater(refused, number // stride // 2, "most of them are needed")
        for first in range(offset, number + 1, stride * 10):
            result = self.fails(arguments, first, number, whole, is_each=True)
            self.assertTrue(result.returncode == 0 or "memory" in result.stderr, result.stderr)

    def fails(self, arguments, first, number, whole, **more):
        return self.check_failing(arguments, "memory", first, whole, is_last=first > number - FOR_THE_LAST_LINE, **more)

    def test_compile(self):
        self.go_through("compile", "marked.kfast", "-o", self.output)

    def test_import(self):
        self.go_through("import", FILM, "-o", self.output)
        self.go_through("import", DRAWING, "-o", self.output)

    def test_render(self):
        self.output = self.folder / "output.gif"
        self.go_through("render", "repeat.kfast", "--all", "-o", self.output)

    def test_upload(self):
        self.board()
        self.go_through("upload", "marked.kfast", "--slot", 0, *self.device)
        self.ask("upload", "marked.kfast", "--slot", 1)

    def test_little_memory(self):
        """A small file that unpacks to more than there is."""
        with zipfile.ZipFile(self.folder / "large.lottie", "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("manifest.json", '{"animations":[{"id":"a"}]}')
            archive.writestr("animations/a.json", '{"layers":[' + ",".join(["[]"] * 1_000_000) + "]}")
        result = subprocess.run([KFAST, "import", "large.lottie"], cwd=self.folder, capture_output=True, text=True, timeout=60,
                                preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (120_000_000, 120_000_000)))
        self.assertEqual((result.returncode, result.stderr), (1, "kfast: not enough memory: try a smaller --size, or a smaller file\n"))


if __name__ == "__main__":
    unittest.main()
