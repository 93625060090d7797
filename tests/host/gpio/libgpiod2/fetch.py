"""Unpacks libgpiod 2 of Debian 13 into <folder>/root: fetch.py <folder>

Nothing is done when it is there. No rights are needed, nothing is installed: apt downloads the packages from the mirror
that this computer has its own packages from."""

import os
import pathlib
import shutil
import subprocess
import sys

SUITE = "trixie"
PACKAGES = ("libgpiod-dev", "libgpiod3")
ELSE = "Or leave the test out: cmake -DKFAST_TEST_LIBGPIOD_2=OFF"


class Failure(Exception):
    pass


def call(*command, **options):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          check=False, **options)
    if done.returncode != 0:
        raise Failure(f"{' '.join(map(str, command))}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout


def mirrors():
    """Those of Debian's main archive."""
    sites = call("apt-get", "indextargets", "--format", "$(SITE)", "Created-By: Packages").split()
    found = [site for site in dict.fromkeys(sites) if site.rstrip("/").endswith("/debian")]
    if not found:
        raise Failure("apt has no source with Debian's main archive, from which libgpiod 2 would come")
    return found


def configuration(work, mirror):
    """For an apt that knows nothing of this computer but its keys."""
    for folder in ("lists/partial", "cache/archives/partial"):
        (work / folder).mkdir(parents=True, exist_ok=True)
    (work / "sources.list").write_text(f"deb {mirror} {SUITE} main\n")
    (work / "apt.conf").write_text(f'''Dir::Etc::sourcelist "{work}/sources.list";
Dir::Etc::sourceparts "/dev/null";
Dir::State::Lists "{work}/lists";
Dir::State::status "/dev/null";
Dir::Cache "{work}/cache";
Acquire::Languages "none";
APT::Sandbox::User "root";
APT::Update::Error-Mode "any";
''')
    return {**os.environ, "APT_CONFIG": str(work / "apt.conf")}


def download(work, mirror):
    shutil.rmtree(work, ignore_errors=True)
    environment = configuration(work, mirror)
    call("apt-get", "-q", "update", env=environment)
    call("apt-get", "-q", "download", *PACKAGES, cwd=work, env=environment)


def unpack(work, root):
    unpacked = work / "unpacked"
    for package in work.glob("*.deb"):
        call("dpkg-deb", "-x", package, unpacked)
    unpacked.rename(root)


def fetch(folder):
    root = folder / "root"
    if root.exists():
        return
    work = folder / "work"
    failures = []
    for mirror in mirrors():
        try:
            download(work, mirror)
            unpack(work, root)
            shutil.rmtree(work)
            return
        except Failure as failure:
            failures.append(f"{mirror}: {failure}")
    raise Failure("\n".join(failures))


if __name__ == "__main__":
    try:
        fetch(pathlib.Path(sys.argv[1]).resolve())
    except Failure as failure:
        sys.exit(f"libgpiod 2 cannot be had from Debian's suite {SUITE}: is the network there?\n{failure}\n{ELSE}")
