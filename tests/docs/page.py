"""Pages of the documentation, taken apart into what the tests look at: blocks of code, links, headings."""

import dataclasses
import pathlib
import re
import shlex

ROOT = pathlib.Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^( *)(`{3,})(\S*)")
KFAST = re.compile(r"(?:^|[|;&(] *|sudo )(?:build/host/bin/)?kfast(?= |$)")
OTHER_COMMAND = re.compile(r"^(scripts/|cmake |ctest |sudo |cp |cd |sed |git |ssh |scp |export |gzip |mkdir |pio |idf\.py |"
                           r"arduino-cli |g\+\+ |npm |pkg-config |mkdocs |code |vim |echo |gdb |man |ffmpeg )")
CLOSING_COMMENT = re.compile(r"\s#\s.*$")
STATUS = re.compile(r"# .*\bexit status (\d+)")
FIGURE = re.compile(r"(?<![\w.,:/-])\d+x\d+\b|(?<![\w.,:/-])\d[\d.,]*\d(?![\w-])")
FILE_NAME = re.compile(r"\A(?://|#) ([\w./-]+\.\w+)\n")


@dataclasses.dataclass
class Block:
    language: str  # of the fence; "" where there is none, "indented" for an indented block
    text: str
    line: int  # of the page, of its first line

    @property
    def file_name(self):
        """The name under which a reader saves it, where its first line tells one."""
        found = FILE_NAME.match(self.text)
        return found.group(1) if found else None

    @property
    def is_commands(self):
        lines = self.text.splitlines()
        if self.language == "indented":
            return any(KFAST.search(line) for line in lines) or bool(OTHER_COMMAND.match(lines[0]))
        return self.language == "sh"

    def commands(self):
        """Pairs of a line's number and a command, whose lines are joined."""
        waiting, begun = "", self.line
        for number, line in enumerate(self.text.splitlines(), self.line):
            begun = begun if waiting else number
            waiting += line + "\n"
            if is_whole(waiting):
                if CLOSING_COMMENT.sub("", "\n" + waiting).strip() and not waiting.startswith("#"):
                    yield begun, waiting.rstrip("\n")
                waiting = ""


def is_whole(text):
    if text.endswith("\\\n"):
        return False
    try:
        shlex.split(text, comments=True)
    except ValueError:
        return False
    return True


def shown_status(command):
    found = STATUS.search(command)
    return int(found.group(1)) if found else 0


def shown_figures(command):
    """Those of two and more digits in the comment behind a command, which it tells."""
    comment = CLOSING_COMMENT.search(command)
    return FIGURE.findall(comment.group()) if comment else []


def blocks(text):
    lines = text.splitlines()
    at = 0
    while at < len(lines):
        fence = FENCE.match(lines[at])
        if fence:
            end = at + 1
            while end < len(lines) and lines[end].strip() != fence.group(2):
                end += 1
            yield Block(fence.group(3), joined(lines[at + 1:end], len(fence.group(1))), at + 2)
            at = end + 1
        elif lines[at].startswith("    ") and (at == 0 or not lines[at - 1].strip()):
            end = at
            while end < len(lines) and (lines[end].startswith("    ") or not lines[end].strip()):
                end += 1
            yield Block("indented", joined(lines[at:end], 4).rstrip("\n") + "\n", at + 1)
            at = end
        else:
            at += 1


def joined(lines, indent):
    return "".join(line[indent:] + "\n" for line in lines)


def prose(text):
    """The page without its blocks of code, line by line; lines keep their numbers."""
    lines = text.splitlines()
    for block in blocks(text):
        count = block.text.count("\n")
        lines[block.line - 1:block.line - 1 + count] = [""] * count
    return lines


def pages():
    """The documents whose commands and scenes a reader would try."""
    return [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")), *sorted((ROOT / "examples").rglob("README.md"))]


def all_pages():
    return sorted(path for folder in ("", "docs", "examples", "tests", "boards", "core", "firmware", "host", "library", "scripts",
                                      "packages", "editors", "cmake")
                  for path in (ROOT / folder).glob("**/*.md" if folder else "*.md")
                  if "node_modules" not in path.parts)
