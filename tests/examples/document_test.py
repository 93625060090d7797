"""Whatever docs/library.md shows as code is code that is compiled: it stands in a file of examples/library as it is."""

import pathlib
import re
import textwrap
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SNIPPET = re.compile(r"^```(c|cpp|cmake)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def runs_of_lines(text, count):
    lines = text.splitlines()
    for begin in range(len(lines) - count + 1):
        yield textwrap.dedent("\n".join(lines[begin:begin + count]))


def stands_in(snippet, text):
    wanted = textwrap.dedent(snippet).rstrip("\n")
    return wanted in runs_of_lines(text, wanted.count("\n") + 1)


class Document(unittest.TestCase):
    def test_shows_only_what_is_compiled(self):
        sources = [path.read_text(encoding="utf-8") for path in sorted((ROOT / "examples/library").iterdir())]
        snippets = SNIPPET.findall((ROOT / "docs/library.md").read_text(encoding="utf-8"))
        self.assertGreater(len(snippets), 4)
        for _, snippet in snippets:
            with self.subTest(snippet=snippet):
                self.assertTrue(any(stands_in(snippet, source) for source in sources))

    def test_notices_a_difference(self):
        self.assertTrue(stands_in("b;\n    c;\n", "a;\n    b;\n        c;\n"))
        self.assertFalse(stands_in("b;\nd;\n", "a;\n    b;\n    c;\n"))


if __name__ == "__main__":
    unittest.main()
