"""A machine whose packages are names in a file: apt-get, dpkg and others that scripts call, pretended."""

import os
import pathlib
import shutil
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Each package has 2 MB to fetch and takes 5 on the disk, with one more that it needs. Options stand before and behind names.
APT_GET = r"""
echo "apt-get $*" >>"$CALLS"
names() { for word in "$@"; do case "$word" in -* | *=* | install | update) ;; *) echo "$word" ;; esac; done; }
case " $* " in
*" update "*) touch "$STATE/lists"; exit 0 ;;
esac
[ -e "$STATE/lists" ] || { echo "E: Unable to locate package" >&2; exit 100; }
case " $* " in
*" --print-uris "*)
    count=$(names "$@" | wc -l)
    echo "0 upgraded, $((2 * count)) newly installed, 0 to remove and 7 not upgraded."
    echo "After this operation, $((5 * count)).0 MB of additional disk space will be used."
    for name in $(names "$@"); do
        [ -e "$STATE/fetched-$name" ] || echo "'http://debian/$name.deb' $name.deb 2000000 MD5Sum:0"
    done ;;
*" --download-only "*)
    [ ! -e "$STATE/old-lists" ] || { rm "$STATE/old-lists"; echo "E: 404  Not Found" >&2; exit 100; }
    for name in $(names "$@"); do touch "$STATE/fetched-$name"; done ;;
*" install "*)
    echo "debconf: delaying package configuration, since apt-utils is not installed" >&2
    for name in $(names "$@"); do
        while [ -e "$STATE/slow-$name" ]; do touch "$STATE/installing-$name"; sleep 0.05; done
        [ ! -e "$STATE/too-large-$name" ] || { echo "dpkg: error: No space left on device" >&2; exit 100; }
    done
    names "$@" >>"$STATE/installed" ;;
esac
"""

PROGRAMS = {
    "apt-get": APT_GET,
    "apt-cache": '[ -e "$STATE/knows-kernel" ]',
    "dpkg-query": 'for name in "$@"; do [ -e "$STATE/all-installed" ] || grep -qx -- "$name" "$STATE/installed" || continue; '
                  'echo "installed $name"; done',
    "dpkg": 'echo "dpkg $*" >>"$CALLS"; [ "$1" != --audit ] || cat "$STATE/half-installed" 2>/dev/null; '
            '[ "$1" != --configure ] || rm "$STATE/half-installed"',
    "id": 'echo "${USER_NUMBER:-0}"',
    "sudo": 'echo "sudo $*" >>"$CALLS"; if [ "$1" = -n ]; then [ ! -e "$STATE/asks-for-password" ] || exit 1; shift; fi; '
            'USER_NUMBER=0 exec "$@"',
    "node": "exit 0",
    "npm": 'echo "npm $*" >>"$CALLS"; eval "$NPM"',
}


class PretendedMachine:
    """`folder` is KFAST there, with the files that are named, and its `calls` are those of programs."""

    def __init__(self, folder, files, programs=None):
        self.folder = folder
        self.state = folder / "state"
        self.state.mkdir()
        (self.state / "installed").touch()
        for name in files:
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, folder / name)
        (folder / "bin").mkdir()
        for name, text in {**PROGRAMS, **(programs or {})}.items():
            (folder / "bin" / name).write_text(f"#!/bin/bash\n{text}\n", encoding="utf-8")
            (folder / "bin" / name).chmod(0o755)
        self.settings = {"CALLS": str(folder / "calls"), "STATE": str(self.state), "NPM": "mkdir node_modules"}

    def has(self, *facts):
        for fact in facts:
            (self.state / fact).write_text("broken-package\n", encoding="utf-8")

    def environment(self, **more):
        path = f"{self.folder / 'bin'}:{os.environ['PATH']}"
        return {**os.environ, "PATH": path, **self.settings, "TMPDIR": str(self.folder), **more}

    def begin(self, *command, **more):
        (self.folder / "calls").write_text("", encoding="utf-8")
        return subprocess.Popen([self.folder / command[0], *command[1:]], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, text=True, env=self.environment(**more), start_new_session=True)

    def run(self, *command, **more):
        process = self.begin(*command, **more)
        out, errors = process.communicate(timeout=60)
        return subprocess.CompletedProcess(command, process.returncode, out, errors)

    def wait_for(self, fact, seconds=30):
        deadline = time.monotonic() + seconds
        while not (self.state / fact).exists():
            if time.monotonic() > deadline:
                raise AssertionError(f"no {fact} within {seconds} seconds")
            time.sleep(0.05)

    def calls(self, start=""):
        lines = (self.folder / "calls").read_text(encoding="utf-8").splitlines()
        return [line for line in lines if line.startswith(start)]

    def installed(self):
        return (self.state / "installed").read_text(encoding="utf-8").split()
