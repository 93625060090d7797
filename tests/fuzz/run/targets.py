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
    """The runs by which so many processors are busy for `seconds`, in their order, and the whole seconds that each of them
    takes: the same for all targets, which run once, or as often as there are processors for each. None is divided,
    because reading a corpus may take long."""
    runs = [(target, number) for number in range(max(1, processors // len(targets))) for target in targets]
    rounds = -(-len(runs) // processors)
    return runs, seconds // rounds
