"""Which branches of the rooms tests have taken, from what llvm-cov exports: scripts/coverage.

A branch is one outcome, true or false, of a condition that a source writes: of each operand of && and || by itself. Each
case of a switch is one, and so is that none of them fits where it has no default. What is compiled several times, as
templates and what headers define are, counts once: a branch is taken if any of them takes it. Not branches at all are

- conditions within the parentheses of expects(), whose false outcome is a bug of the caller (core/bytes/expects.hpp),
- those that the compiler decides, as of `if constexpr`, or writes, as of `operator==(...) = default`.
"""

import argparse
import json
import os
import pathlib
import re
import sys
from collections import defaultdict
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[1]
ROOMS = ("core/scene/check", "firmware/link", "firmware/slots", "firmware/usb", "host/link")
LEAST_SHARE = 95


@dataclass(frozen=True, order=True)
class Condition:
    """Where one is in a file, as llvm-cov counts lines and columns: from 1 on, the end is behind it."""
    line: int
    column: int
    last_line: int
    last_column: int

    def text(self, lines):
        """As the source writes it, in one line."""
        part = lines[self.line - 1:self.last_line]
        part = [*part[:-1], part[-1][:self.last_column - 1]]
        part[0] = part[0][self.column - 1:]
        return " ".join(piece.strip() for piece in part)


@dataclass
class Room:
    name: str
    lines: int
    covered_lines: int
    branches: int
    missing: list  # of (file, line, what never happened)

    def share(self):
        """Percent of the branches, rounded down to tenths: 94.96 are not 95."""
        return (self.branches - len(self.missing)) * 1000 // self.branches / 10 if self.branches else 100.0


def room_of(name, rooms=ROOMS):
    """The room in whose folder itself the file is."""
    folder = name and str(pathlib.PurePosixPath(name).parent)
    return folder if folder in rooms else None


def name_of(file, root):
    """Its name from `root`, from where a compiler may see it as ../../it; none of what is elsewhere."""
    path = pathlib.PurePosixPath(os.path.normpath(file))
    return str(path.relative_to(root)) if path.is_relative_to(root) else None


def outcomes(exports, root):
    """For each file, by its name from `root`, how often each condition was true and false, all that is compiled of it
    together."""
    counts = defaultdict(lambda: defaultdict(lambda: (0, 0)))
    for export in exports:
        for function in export["functions"]:
            names = [name_of(file, root) for file in function["filenames"]]
            for *place, true, false, file, _, _ in function["branches"]:
                conditions = counts[names[file]]
                before = conditions[Condition(*place)]
                conditions[Condition(*place)] = (before[0] + true, before[1] + false)
    return counts


def lines_of(exports, root):
    """For each file, how many lines it has that do something, and how many of them were run: where more of them were."""
    lines = defaultdict(lambda: (0, 0))
    for export in exports:
        for file in export["files"]:
            name = name_of(file["filename"], root)
            found = file["summary"]["lines"]
            lines[name] = max(lines[name], (found["covered"], found["count"]))
    return lines


def contracts(text):
    """Where the arguments of expects() are: pairs of offsets."""
    found = []
    for call in re.finditer(r"\bexpects\(", text):
        depth = 1
        end = call.end()
        while depth > 0:
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
        found.append((call.end(), end))
    return found


def is_excluded(condition, text, starts):
    """Whether it is a condition of a contract, or one that the compiler decides or writes."""
    at = starts[condition.line - 1] + condition.column - 1
    return any(begin <= at < end for begin, end in contracts(text)) or text[:at].endswith("if constexpr (") or \
        text[starts[condition.line - 1]:starts[condition.line] - 1].endswith(" = default;")


def branches_of(condition, text, starts, lines):
    """What may happen, and whether `counts` (true, false) say that it did: pairs of words and a place in `counts`."""
    words = condition.text(lines)
    before = text[:starts[condition.line - 1] + condition.column - 1]
    if re.match(r"case\b|default\b", words):
        return [(f"never here: {words}", 0)]
    if before.endswith("switch ("):
        return [(f"never without a case: switch ({words})", 0)]
    return [(f"never true: {words}", 0), (f"never false: {words}", 1)]


def missing_of(name, text, conditions):
    """How many branches a file has, and those that were not taken."""
    lines = text.split("\n")
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line) + 1)
    count = 0
    missing = []
    for condition, counts in sorted(conditions.items()):
        if is_excluded(condition, text, starts):
            continue
        branches = branches_of(condition, text, starts, lines)
        count += len(branches)
        missing += [(name, condition.line, words) for words, place in branches if counts[place] == 0]
    return count, missing


def measured(exports, root, rooms=ROOMS):
    """Those rooms, in their order, with all their files that were compiled."""
    found = {name: Room(name, 0, 0, 0, []) for name in rooms}
    for file, (covered, count) in lines_of(exports, root).items():
        if name := room_of(file, rooms):
            found[name].lines += count
            found[name].covered_lines += covered
    for file, conditions in outcomes(exports, root).items():
        if name := room_of(file, rooms):
            count, missing = missing_of(file, (root / file).read_text(encoding="utf-8"), conditions)
            found[name].branches += count
            found[name].missing += missing
    return list(found.values())


def table(rooms):
    width = max(len(room.name) for room in rooms)
    yield f"{'':{width}}   lines    branches  not taken"
    for room in rooms:
        lines = 100 * room.covered_lines / room.lines if room.lines else 100
        yield f"{room.name:{width}}  {lines:5.1f} %  {room.share():5.1f} % of {room.branches:4}  {len(room.missing):5}"


def places(rooms):
    for room in rooms:
        for name, line, words in sorted(room.missing):
            yield f"{name}:{line}: {words}"


def main():
    parser = argparse.ArgumentParser(prog="scripts/coverage", description="Which branches of rooms the tests do not take.")
    parser.add_argument("rooms", nargs="*", metavar="ROOM", help=f"of {', '.join(ROOMS)}; without one, all")
    parser.add_argument("--export", type=pathlib.Path, action="append", help=argparse.SUPPRESS) # without it the rooms alone are looked at
    chosen = parser.parse_args()
    if unknown := set(chosen.rooms) - set(ROOMS):
        parser.error(f"{', '.join(sorted(unknown))} is none of {', '.join(ROOMS)}")
    if not chosen.export:
        return 0
    exports = [json.loads(file.read_text(encoding="utf-8"))["data"][0] for file in chosen.export]
    rooms = measured(exports, ROOT, chosen.rooms or ROOMS)
    print(*places(rooms), *table(rooms), sep="\n")
    below = [room.name for room in rooms if room.share() < LEAST_SHARE]
    if below:
        print(f"Less than {LEAST_SHARE} % of the branches are taken: {', '.join(below)}", file=sys.stderr)
    return 1 if below else 0


if __name__ == "__main__":
    sys.exit(main())
