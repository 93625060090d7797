"""scripts/site_links.py takes links away that a site has no file for, or leads them to the code host, and leaves all others alone."""

import sys
import unittest

from page import ROOT, prose

sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True
from site_links import on_page_markdown

HOST = "https://code.example/kfast"


def without_host(markdown):
    return on_page_markdown(markdown, config={"repo_url": None})


def with_host(markdown, url=HOST):
    return on_page_markdown(markdown, config={"repo_url": url}, page=None, files=None)


class SiteLinks(unittest.TestCase):
    def test_links_within_the_site_stay(self):
        for link in ("[keys](preview.md)", "[keys](preview.md#keys)", "[above](#keys)", "![A window](pictures/preview.png)",
                     "[KDL](https://kdl.dev/)", "`../examples/`", "a path (../examples) in brackets"):
            with self.subTest(link=link):
                self.assertEqual(without_host(link), link)
                self.assertEqual(with_host(link), link)

    def test_of_a_link_to_a_file_outside_the_words_stay(self):
        self.assertEqual(without_host("See [the eyes](../examples/eyes.kfast), and [more](../examples)."), "See the eyes, and more.")
        self.assertEqual(without_host("[`pico`](../boards/pico/README.md#pins) or [fit](fit.md)"), "`pico` or [fit](fit.md)")
        self.assertEqual(without_host("![A picture](../examples/eyes.png)"), "A picture")

    def test_a_host_of_code_has_these_files(self):
        for url in (HOST, HOST + "/"):
            self.assertEqual(with_host("See [the eyes](../examples/eyes.kfast).", url),
                             f"See [the eyes]({HOST}/blob/main/examples/eyes.kfast).")
            self.assertEqual(with_host("[pins](../boards/pico/README.md#pins)", url),
                             f"[pins]({HOST}/blob/main/boards/pico/README.md#pins)")

    def test_no_page_keeps_a_link_out_of_the_site(self):
        for path in (ROOT / "docs").glob("*.md"):
            with self.subTest(page=path.name):
                self.assertNotIn("](../", "\n".join(prose(without_host(path.read_text(encoding="utf-8")))))


if __name__ == "__main__":
    unittest.main()
