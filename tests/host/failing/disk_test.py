"""Where a file cannot be written the command names it and leaves everything as it was: one call after the other fails."""

import errno
import unittest

from failing_case import DRAWING, FailingTest

ERRORS = {errno.ENOSPC: "No space left on device", errno.EIO: "Input/output error"}


class DiskTest(FailingTest):
    def go_through(self, *arguments, name=None):
        """The last call brings the folder to the disk, and the file is there by then."""
        whole, number = self.whole(arguments, "files")
        for error, text in ERRORS.items():
            for first in range(1, number + 1):
                for is_each in (False, True):
                    result = self.check_failing(arguments, "files", first, whole, is_last=first == number,
                                                is_each=is_each, error=error)
                    self.assertEqual(result.returncode, 1, f"{arguments}: call {first} failed")
                    self.assertIn(f"cannot write {name or self.output}: {text}: ", result.stderr)
        return number

    def test_a_scene(self):
        # open, write, fsync, close and rename of the file, and fsync of the folder
        self.assertEqual(self.go_through("compile", "marked.kfast", "-o", self.output), 6)

    def test_pictures(self):
        for name in ("output.png", "output.gif", "output.apng", "output.svg"):
            self.output = self.folder / name
            self.go_through("render", "repeat.kfast", *([] if name in ("output.png", "output.svg") else ["--all"]),
                            "-o", self.output)
            self.output.unlink()

    def test_a_folder_of_pictures(self):
        (self.folder / "short.kfast").write_text("kfast 1\ncanvas 8 8 frames=3\nobject a fill=red { rect 0 0 9 9 }\n")
        pictures = self.folder / "pictures"
        arguments = ("render", "short.kfast", "--all", "-o", pictures)
        result, number = self.run_failing(arguments, "files")
        self.assertEqual(result.returncode, 0, result.stderr)
        # open, write, close and rename of each, and one syncfs for all
        self.assertEqual(number, 3 * 4 + 1)
        for first in range(1, number + 1):
            result, _ = self.run_failing(arguments, "files", first, error=errno.EIO)
            self.assertEqual(result.returncode, 1, f"call {first} failed")
            self.assertIn(f"cannot write {pictures}", result.stderr)
            self.assertEqual([path for path in pictures.iterdir() if ".tmp" in path.name], [])

    def test_an_import(self):
        self.go_through("import", DRAWING, "-o", self.output)

    def test_a_header(self):
        self.go_through("export", "marked.kfast", "--header", "-o", self.output)

    def test_a_name_without_a_folder(self):
        self.go_through("compile", "marked.kfast", "-o", "output", name="output")

    def test_a_sheet_and_its_list(self):
        self.output = self.folder / "output.png"
        arguments = ("render", "repeat.kfast", "--sheet", 2, "-o", self.output)
        result, number = self.run_failing(arguments, "files")
        self.assertEqual(result.returncode, 0, result.stderr)
        for first in range(1, number + 1):
            result, _ = self.run_failing(arguments, "files", first, error=errno.EIO)
            self.assertEqual(result.returncode, 1)
            self.assertIn("Input/output error", result.stderr)
            self.assertEqual([path for path in self.folder.iterdir() if ".tmp" in path.name], [])


if __name__ == "__main__":
    unittest.main()
