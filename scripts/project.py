"""What all packages say of the project: packages/project.json, which the owner of the project fills in (docs/release.md)."""

import json
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[1]
FILE = ROOT / "packages/project.json"

# For each fact how it is written, and what a release lacks without it; of those that there must be, nothing.
FACTS = {
    "name": (r"\w+", None),
    "version": (r"\d+\.\d+\.\d+", None),
    "author": (r'[^<>"\\@]+', None),
    "mail": (r"[^@\s<>\"\\]+@[^@\s<>\"\\]+\.[^@\s<>\"\\]+", "Debian's packages name nobody who can be written to"),
    "url": (r"https?://[^\s\"\\]+", "the registries of Arduino, PlatformIO and ESP-IDF want a page where the project is found"),
}


class Failure(Exception):
    pass


def facts(file=FILE):
    """Those of FACTS, those that are not set as None; and `maintainer`, the author with the mail as far as it is set.
    Throws Failure for what is missing, unknown or written otherwise."""
    try:
        found = json.loads(file.read_text(encoding="utf-8"))
    except ValueError as failure:
        raise Failure(f"{file}: {failure}") from failure
    if set(found) != set(FACTS):
        raise Failure(f"{file}: there have to be {', '.join(FACTS)}; {', '.join(sorted(set(found) ^ set(FACTS)))} is the difference")
    for name, (form, lack) in FACTS.items():
        value = found[name]
        if value is None and lack is not None:
            continue
        if not isinstance(value, str) or not re.fullmatch(form, value):
            raise Failure(f"{file}: {name} is {json.dumps(value)}, which is none")
    return found | {"maintainer": f"{found['author']} <{found['mail']}>" if found["mail"] else found["author"]}


def missing(file=FILE):
    """What is not set yet, as sentences."""
    found = facts(file)
    return [f"{file.relative_to(file.parents[1])} has no {name} yet: {lack}"
            for name, (_, lack) in FACTS.items() if found[name] is None]
