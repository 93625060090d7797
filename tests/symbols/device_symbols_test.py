"""Shows that device_symbols.py finds what it is there to find: device_symbols_test.py <compiler> <nm>"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

from device_symbols import check

COMPILER, NM = sys.argv[1:3]

BAD = {
    "heap": [
        "int* f() { return new int; }",
        "void f(int* p) { delete p; }",
        'extern "C" void* malloc(unsigned); void* f() { return malloc(4); }',
    ],
    "software floating point": [
        "float f(float a, float b) { return a + b; }",
        "double f(double a, double b) { return a * b; }",
        "bool f(float a, float b) { return a < b; }",
        "float f(int a) { return a; }",
        "int f(double a) { return int(a); }",
        "double f(float a) { return a; }",
    ],
    "exceptions": ["void f() { throw 1; }"],
    "data that must be copied to RAM": ["int f = 3; namespace n { int f = 4; }"],
}


class DeviceSymbols(unittest.TestCase):
    def found(self, text):
        with tempfile.TemporaryDirectory() as folder:
            source, result = pathlib.Path(folder, "a.cpp"), pathlib.Path(folder, "a.o")
            source.write_text(text)
            subprocess.run([COMPILER, "-mcpu=cortex-m0", "-mthumb", "-O1", "-c", source, "-o", result], check=True,
                           timeout=60)
            return check(NM, str(result))

    def test_accepts_integers(self):
        self.assertEqual([], self.found("int table(int i) { return i / 3; } int f(long long a) { return int(a / 7); }"))

    def test_names_what_is_forbidden(self):
        for what, texts in BAD.items():
            for text in texts:
                with self.subTest(text=text):
                    self.assertIn(what, " ".join(self.found(text)))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
