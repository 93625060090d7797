"""Which shared libraries a program of Linux needs, and which packages of Debian they belong to: those of this computer, or
of the folder that scripts/make_sysroot.py makes for another one.

    shared_libraries.py depends PROGRAM ROOT    what a package with the program depends on, as the field Depends has it"""

import functools
import pathlib
import re
import sys

from debian_packages import Failure, call

READ = re.compile(r"\((NEEDED|SONAME|RPATH|RUNPATH)\).*\[(.*)\]")


class Libraries:
    """Those below `root`, "/" for those of this computer."""

    def __init__(self, root="/"):
        self._root = pathlib.Path(root).resolve()
        self._database = self._root / "var/lib/dpkg"
        self._of_root = [f"--admindir={self._database}"]

    def needed(self, program):
        """All that a program needs, the dynamic loader too: name to file. Throws Failure for one that there is not."""
        found, waiting = {}, [pathlib.Path(program)]
        folders = self._folders_for(waiting[0])
        while waiting:
            asking = waiting.pop()
            entries = dynamic_entries(asking)
            own = [self._root / path.lstrip("/") for kind, paths in entries if kind in ("RPATH", "RUNPATH")
                   for path in paths.replace("$ORIGIN", str(asking.parent)).split(":")]
            for name in (value for kind, value in entries if kind == "NEEDED" and value not in found):
                found[name] = find(name, [*own, *folders], asking)
                waiting.append(found[name])
        return found

    def package_of(self, library):
        """The name of the package that has this file."""
        for path in names_of(self._root, library):
            if path in self._owners:
                return self._owners[path]
        raise Failure(f"no package has {library}")

    def versions_of(self, packages):
        """For each package its source package with the version, as glibc=2.36-9."""
        said = call("dpkg-query", *self._of_root, "--show", "--showformat",
                    "${Package} ${source:Package}=${source:Version}\n", *packages).decode()
        return dict(line.split() for line in said.splitlines())

    def copyright_of(self, package):
        return self._root / "usr/share/doc" / package / "copyright"

    def depends(self, program):
        """What a package with this program depends on."""
        names = [value for kind, value in dynamic_entries(program) if kind == "NEEDED"]
        found = self.needed(program)
        return sorted({self._dependency(found[name]) for name in names})

    def _dependency(self, library):
        package = self.package_of(library)
        (soname,) = (value for kind, value in dynamic_entries(library) if kind == "SONAME")
        name, version = re.match(r"(.+?)(?:\.so\.(.+)|-([\d.]+)\.so)$", soname).group(1, 2)
        for file in self._database.glob(f"info/{package}[:.]*shlibs"):
            for line in file.read_text(encoding="utf-8").splitlines():
                if line.split()[:2] == [name, version] and "(" in line:
                    return " ".join(line.split()[2:])
        # The libraries of GCC name their symbols of each version in its place.
        upstream = call("dpkg-query", *self._of_root, "--show", "--showformat", "${source:Upstream-Version}", package).decode()
        return f"{package} (>= {upstream})"

    @functools.cached_property
    def _owners(self):
        """The package of each library that any has, by its path as the package has it."""
        return {path: file.name.removesuffix(".list").split(":")[0] for file in self._database.glob("info/*.list")
                for path in file.read_text(encoding="utf-8").splitlines() if ".so" in path}

    def _folders_for(self, program):
        machine = re.search(r"Machine: +(.*)", call("readelf", "--file-header", program).decode())[1]
        triplet = "aarch64-linux-gnu" if machine == "AArch64" else "x86_64-linux-gnu"
        return [self._root / folder / triplet for folder in ("lib", "usr/lib")]


def dynamic_entries(file):
    return READ.findall(call("readelf", "--dynamic", "--wide", file).decode())


def names_of(root, file):
    """By which a package may know a file: with its links and without, and where /lib is /usr/lib as well."""
    for each in (file, file.resolve()):
        path = "/" + str(each.relative_to(root))
        yield from (path, path.removeprefix("/usr") if path.startswith("/usr/") else f"/usr{path}")


def find(name, folders, asking):
    for folder in folders:
        if (folder / name).is_file():
            return folder / name
    raise Failure(f"{asking} needs {name}, which is in none of {', '.join(map(str, folders))}")


if __name__ == "__main__":
    if len(sys.argv) != 4 or sys.argv[1] != "depends":
        sys.exit(__doc__)
    try:
        print(", ".join(Libraries(sys.argv[3]).depends(pathlib.Path(sys.argv[2]))))
    except Failure as problem:
        sys.exit(str(problem))
