"""A hook of MkDocs. The site begins with the first screen of the README, and the list of pages of docs/index.md below it: on a code
host each of them has a page of its own. The first screen is all of README.md in front of the line END."""

import pathlib
import re

README = pathlib.Path(__file__).resolve().parents[1] / "README.md"
END = "<!-- the first screen ends here -->"
LINK = re.compile(r"(!?\[[^\]]+\]\()(?![a-z]+:|#)([^)]+)\)")
FIRST_SECTION = re.compile(r"^## ", re.MULTILINE)


def first_screen(readme):
    """With links as a page in docs/ has them."""
    screen, found, _ = readme.partition(END)
    if not found:
        raise ValueError(f"README.md has no line {END}")
    return LINK.sub(lambda link: link[1] + seen_from_docs(link[2]) + ")", screen).rstrip() + "\n"


def seen_from_docs(target):
    return target.removeprefix("docs/") if target.startswith("docs/") else "../" + target


def list_of_pages(index):
    return index[FIRST_SECTION.search(index).start():]


def on_page_markdown(markdown, page, **_):
    if page.file.src_path != "index.md":
        return markdown
    return first_screen(README.read_text(encoding="utf-8")) + "\n" + list_of_pages(markdown)
