"""What scripts/assemble made, for the tests of it."""

import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
STUBS = ROOT / "tests/packages"


def output_of(*command, **more):
    return subprocess.run([*map(str, command)], check=True, stdout=subprocess.PIPE, timeout=300, **more).stdout


def assembled(framework, folder):
    return pathlib.Path(output_of(ROOT / "scripts/assemble", framework, folder, text=True).strip())


def temporary_folder(test_class):
    temporary = tempfile.TemporaryDirectory(prefix="kfast")
    test_class.addClassCleanup(temporary.cleanup)
    return pathlib.Path(temporary.name)
