"""A Linux of Debian's kernel that runs in QEMU and sees the files of this computer, without any rights."""

import dataclasses
import pathlib
import shlex
import shutil
import subprocess
import tempfile
import threading

from pico import expect

LONGEST = 900  # seconds
END = "GUEST exit"


def share(tag, folder):
    path = str(folder).replace(",", ",,")
    return ["-fsdev", f"local,id={tag},path={path},security_model=none,readonly=on,multidevs=remap",
            "-device", f"virtio-9p-pci,fsdev={tag},mount_tag={tag}"]


@dataclasses.dataclass(frozen=True)
class Machine:
    """What a guest runs on."""
    qemu: tuple  # the program, and its arguments for the machine
    console: str  # as its kernel calls it
    computer: str = "/"  # the folder that the guest has for /computer


PC = Machine(("qemu-system-x86_64", "-cpu", "qemu64",
              "-netdev", "user,id=net", "-device", "virtio-net-pci,netdev=net,romfile="), "ttyS0")


class LinuxGuest:
    """Boots what guest/make_guest.py has made in `folder`, and runs `task`, a text for its shell: guest/init has what
    it may use, and /task has `files`. What it prints can be waited for. Whatever fails is an AssertionError, at the end
    of `with` at the latest."""

    def __init__(self, folder, task, machine=PC, files=()):
        folder = pathlib.Path(folder)
        expect((folder / "kernel").is_file(), f"{folder} has no guest: guest/make_guest.py makes it")
        self._task = tempfile.TemporaryDirectory(prefix="kfast")
        (pathlib.Path(self._task.name) / "task.sh").write_text(task, encoding="utf-8")
        for file in files:
            shutil.copy(file, self._task.name)
        self.console = []
        self._qemu = subprocess.Popen(
            [*machine.qemu, "-accel", "tcg", "-m", "256", "-display", "none", "-monitor", "none",
             "-serial", "stdio", "-no-reboot", "-nodefaults",
             "-kernel", folder / "kernel", "-initrd", folder / "initrd.gz",
             "-append", f"console={machine.console} loglevel=1 panic=-1 mitigations=off nokaslr",
             *share("computer", machine.computer), *share("task", self._task.name)],
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
        self._watch = threading.Timer(LONGEST, self._qemu.kill)
        self._watch.start()

    def wait_for(self, text):
        """Until the console says it; the line."""
        for line in self._qemu.stdout:
            self.console.append(line.strip())
            if text in line:
                return self.console[-1]
            if text != END and END in line:
                break
        raise AssertionError(f"the guest never says “{text}”:\n" + "\n".join(self.console))

    def wait_for_request(self, name):
        """Until the task wants a permission of that name."""
        self.wait_for(f"AWAIT {name}")

    def permit(self, name):
        (pathlib.Path(self._task.name) / name).touch()

    def end(self):
        """Waits until the task ends, which must succeed, and QEMU with it."""
        status = self.wait_for(END).split()[-1]
        expect(status == "0", f"the task ends with {status}:\n" + "\n".join(self.console))
        self._qemu.communicate(timeout=60)

    def __enter__(self):
        return self

    def __exit__(self, kind, *_):
        try:
            if kind is None:
                self.end()
        finally:
            self._qemu.kill()
            self._qemu.communicate()
            self._watch.cancel()
            self._task.cleanup()


def quoted(*words):
    return " ".join(shlex.quote(str(word)) for word in words)
