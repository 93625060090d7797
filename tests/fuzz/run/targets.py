"""The fuzz targets, and how a time is shared among them."""

import dataclasses
import json
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[3]
SOURCES = ROOT / "tests/fuzz"
BUILT = ROOT / "build/sanitize/fuzz_targets.json"


@dataclasses.dataclass(frozen=True)
class Target:
    name: str
    program: pathlib.Path
    seeds: tuple  # folders that are committed: nothing is written to them
    dictionary: pathlib.Path | None = None


def names_in_sources():
    return sorted(source.name.removesuffix("_fuzz.cpp") for source in SOURCES.glob("*_fuzz.cpp"))


def read_targets(file):
    """As add_fuzz_target() describes them."""
    return [Target(found["name"], pathlib.Path(found["program"]), tuple(map(pathlib.Path, found["seeds"])),
                   dictionary_of(found["name"])) for found in json.loads(file.read_text(encoding="utf-8"))]


def dictionary_of(name):
    file = SOURCES / "dictionaries" / f"{name}.dict"
    return file if file.exists() else None


def shares(targets, processors, seconds):
    """For each processor the targets that it runs, one after the other, with their seconds. All targets have the same
    share of `seconds` (whole ones) on so many processors. One that a processor has no time left for goes on with the next
    one: in the beginning of the time, so that it does not run beside itself unless there are more processors than
    targets. The share is less than a second, and nothing is run, if there are too few seconds."""
    share = seconds * processors // len(targets)
    lines = [[] for _ in range(processors)]
    at = 0  # as if processors worked one after the other
    for target in targets:
        end = at + share
        while at < end:
            part = min(end, (at // seconds + 1) * seconds) - at
            lines[at // seconds].append((target, part))
            at += part
    return lines
