"""Checks that every include respects the rooms of docs/design.md: layering.py <root of the repository>."""

import collections
import pathlib
import re
import sys

# Folders whose rooms, and what each of them may include, stand in tables of docs/design.md, and how many files a
# room may have.
MOST_FILES = {"core": 40, "firmware": 40, "library": 40, "boards": 40, "host": 60}

# Folders without rooms: what they may include, as a whole.
WITHOUT_ROOMS = {"examples": {"core"}, "tests": {"tests", *MOST_FILES}}

# The only headers in angle brackets for what runs on every device. <cstdlib> is for std::abs, <new> to place a player in
# lent memory; the heap of both is watched by device_symbols.py.
FREESTANDING = {
    "algorithm", "array", "bit", "compare", "concepts", "cstddef", "cstdint", "cstdlib", "limits", "new", "optional",
    "span", "stddef.h", "stdint.h", "string_view", "type_traits", "utility",
}
FREESTANDING_FOLDERS = {"core", "firmware", "library"}

# Libraries that one file each hides from the rest, or one for each of its versions: name_v1.cpp, name_v2.cpp. Tests of what
# stands in for them use them as well.
HIDDEN = {
    "SDL": r"SDL.*", "libsndfile": r"sndfile\.hh?", "hidapi": r"hidapi.*", "libusb": r"libusb.*", "libgpiod": r"gpiod.*",
    "FreeType": r"freetype\.h|ft\w+\.h", "libzip": r"zip\.h", "zlib": r"zlib\.h",
}

# Of one library, what several files hide has nothing to do with each other: windows and sound; the outlines of fonts, the
# letters of a window and its polygons.
PARTS = {"SDL": 2, "FreeType": 2}

# Libraries that stay in a few folders, and in what lies in these.
WITHIN = {"pugixml": (r"pugi(xml|config)\.hpp", {"host/svg", "host/synfig"})}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
TABLE = re.compile(r"^\| room(?: of `(?P<folder>[\w/]+)/`)? \| is \| may include \|\n\|[-|]+\|\n(?P<rows>(?:\|.*\n?)+)", re.MULTILINE)


class Rooms:
    """The rooms of docs/design.md: folders, and files that are a room of their own. What a room may include are names of
    rooms; one that ends with / stands for a folder with all that lies in it."""

    def __init__(self, text):
        self.allowed = {}
        self.mistakes = []
        for table in TABLE.finditer(text):
            for row in table["rows"].splitlines():
                self._add(row, table["folder"])

    def _add(self, row, folder):
        cells = row.strip().strip("|").split("|")
        if len(cells) != 3:
            self.mistakes.append(f"docs/design.md: not three cells: {row}")
            return
        names, _, included = (re.findall(r"`([^`]+)`", cell) for cell in cells)
        for name in (written_out(name, folder) for name in names):
            if name in self.allowed:
                self.mistakes.append(f"docs/design.md: {name} stands in two rows")
            self.allowed[name] = [written_out(i, folder) for i in included]

    def of(self, path):
        """The room of a file; None if it is in none."""
        return next((room for room in (path, str(pathlib.PurePosixPath(path).parent)) if room in self.allowed), None)

    def meant_by(self, name):
        """The rooms that a name in the last column stands for."""
        if not name.endswith("/"):
            return {name}
        return {room for room in self.allowed if room == name[:-1] or room.startswith(name)}

    def circles(self):
        """Each as the rooms along it."""
        done, found = set(), []

        def visit(room, way):
            if room in way:
                found.append([*way[way.index(room):], room])
            elif room not in done:
                for name in self.allowed.get(room, []):
                    for included in sorted(self.meant_by(name) - {room}):
                        visit(included, [*way, room])
                done.add(room)

        for room in self.allowed:
            visit(room, [])
        return found


def written_out(name, folder):
    if folder is None or name.split("/")[0] in MOST_FILES:
        return name
    return folder if name == "." else f"{folder}/{name}"


def sources(root):
    for folder in [*MOST_FILES, *WITHOUT_ROOMS]:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in {".hpp", ".cpp", ".h", ".c", ".in"}:
                yield folder, path


def quoted_mistake(folder, place, included, rooms):
    if ".." in pathlib.PurePosixPath(included).parts:
        return "climbs out of its folder"
    if folder == "examples" and "/" not in included:
        return None  # a project of its own, with its header beside it
    layer = included.split("/")[0]
    if layer not in MOST_FILES and layer not in WITHOUT_ROOMS:
        return "is not written from the root of the repository"
    if folder in WITHOUT_ROOMS:
        return None if layer in WITHOUT_ROOMS[folder] else f"reaches from {folder} into {layer}"
    own, other = rooms.of(place), rooms.of(included)
    if own is None or own == other or any(other in rooms.meant_by(name) for name in rooms.allowed[own]):
        return None
    return f"reaches from {own} into {other or layer}"


def angle_mistake(folder, included):
    if "/" in included and included.split("/")[0] in {*MOST_FILES, *WITHOUT_ROOMS}:
        return "is ours, and belongs into quotes"
    if folder in FREESTANDING_FOLDERS and included not in FREESTANDING:
        return f"is no freestanding header, as {folder}/ needs"
    return None


def hidden_library(included):
    name = included.split("/")[-1]
    return next((library for library, pattern in HIDDEN.items() if re.fullmatch(pattern, name)), None)


def strayed_library(place, included):
    for library, (pattern, folders) in WITHIN.items():
        if re.fullmatch(pattern, included.split("/")[-1]) and not any(place.startswith(f"{folder}/") for folder in folders):
            return f"is of {library}, which belongs into {', '.join(sorted(folders))}"
    return None


def room_mistakes(root, rooms):
    """Of the rooms themselves: what lies in none, what is too full, and what the tables say in vain."""
    files, used = collections.defaultdict(set), collections.defaultdict(set)
    for folder, path in sources(root):
        place = path.relative_to(root).as_posix()
        if folder not in MOST_FILES:
            continue
        room = rooms.of(place)
        if room is None:
            if path.suffix != ".in":
                yield f"{place}: is in no room of docs/design.md"
            continue
        files[str(pathlib.PurePosixPath(place).parent)].add(path)
        files[room].add(path)
        used[room] |= {rooms.of(included) for kind, included in INCLUDE.findall(path.read_text(encoding="utf-8")) if kind == '"'}
    for room, names in rooms.allowed.items():
        if room not in files:
            yield f"docs/design.md: {room} has no files"
        for name in names:
            if not rooms.meant_by(name) & used[room]:
                yield f"docs/design.md: {room} may include {name}, and does not"
    for folder, inside in files.items():
        if len(inside) > MOST_FILES[folder.split("/")[0]]:
            yield f"{folder}: has {len(inside)} files, more than {MOST_FILES[folder.split('/')[0]]}"
    for circle in rooms.circles():
        yield f"docs/design.md: rooms include each other: {' > '.join(circle)}"


def check(root):
    """All violations below `root`, one line each."""
    rooms = Rooms((root / "docs/design.md").read_text(encoding="utf-8"))
    mistakes = [*rooms.mistakes, *room_mistakes(root, rooms)]
    users = {library: set() for library in HIDDEN}
    for folder, path in sources(root):
        place = path.relative_to(root).as_posix()
        for kind, included in INCLUDE.findall(path.read_text(encoding="utf-8")):
            mistake = quoted_mistake(folder, place, included, rooms) if kind == '"' else angle_mistake(folder, included)
            if not mistake and folder != "tests":
                mistake = strayed_library(place, included)
            if mistake:
                mistakes.append(f"{place}: {included} {mistake}")
            if folder != "tests" and (library := hidden_library(included)):
                users[library].add(path.relative_to(root))
    for library, places in users.items():
        names = {re.sub(r"_v\d$", "", str(place.with_suffix(""))) for place in places}
        if len(names) > PARTS.get(library, 1) or any(place.suffix != ".cpp" for place in places):
            files = "one .cpp" if library not in PARTS else f"{PARTS[library]} .cpp"
            mistakes.append(f"{library} must be included by {files} alone: {', '.join(map(str, sorted(places)))}")
    return mistakes


if __name__ == "__main__":
    found = check(pathlib.Path(sys.argv[1]))
    print("\n".join(found) or "every include respects the rooms")
    sys.exit(1 if found else 0)
