"""Shows that nobody can release a device with a number that is for trials alone: usb_id_test.py <compiler> <root>"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

COMPILER, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
HEADER = (ROOT / "firmware/usb/usb_id.hpp").read_text(encoding="utf-8")


def compiled(header, *options):
    with tempfile.NamedTemporaryFile("w", suffix=".hpp") as file:
        file.write(header)
        file.flush()
        return subprocess.run([COMPILER, "-std=c++20", "-fsyntax-only", *options, "-x", "c++", file.name],
                              capture_output=True, text=True, timeout=100, check=False)


class UsbId(unittest.TestCase):
    def test_development_has_any(self):
        run = compiled(HEADER)
        self.assertEqual(0, run.returncode, run.stderr)

    def test_a_release_refuses_the_test_ids(self):
        for product in ("0x0001", "0x0010"):
            run = compiled(HEADER.replace("product_id = 0x0001;", f"product_id = {product};"), "-DKFAST_RELEASE")
            self.assertNotEqual(0, run.returncode)
            self.assertIn("for development alone", run.stderr)

    def test_a_release_takes_its_own(self):
        self.assertIn("product_id = 0x0001;", HEADER, "has it got its own? Then this test is the last to know")
        run = compiled(HEADER.replace("product_id = 0x0001;", "product_id = 0x4B46;"), "-DKFAST_RELEASE")
        self.assertEqual(0, run.returncode, run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
