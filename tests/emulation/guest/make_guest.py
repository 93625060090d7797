"""Makes the kernel and the first file system of a Linux guest, from Debian's packages:

    make_guest.py FOLDER [amd64 | arm64]

They go to FOLDER/kernel and FOLDER/initrd.gz; nothing is done when they are there. No rights are needed, nothing is
installed: apt downloads the packages, for which it must know those of amd64 (apt-get update)."""

import dataclasses
import gzip
import lzma
import pathlib
import re
import shutil
import struct
import sys
from typing import Callable

HERE = pathlib.Path(__file__).resolve().parent
SCRIPTS = HERE.parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))

from debian_packages import DebianPackages, Failure, call, unpack  # noqa: E402 (lies there)

FOR_FILES = ("virtio_pci", "9p", "9pnet_virtio")
FOLDERS_FOR_FILES = ("drivers/virtio", "net/9p", "fs/9p", "fs/netfs", "fs/fscache")
FOR_DRIVES = ("loop", "vfat", "nls_cp437", "nls_ascii")
FOLDERS_FOR_DRIVES = ("drivers/block", "fs/fat", "fs/nls")


@dataclasses.dataclass(frozen=True)
class Kind:
    """What goes into a guest."""
    packages: tuple  # besides the kernel
    modules: tuple
    module_folders: tuple
    has_udev: bool
    kernel: Callable[[bytes], bytes]  # out of that of the package


def uncompressed(image):
    """The ELF file within a bzImage, which starts faster: see the kernel's Documentation/x86/boot.rst."""
    sectors = image[0x1F1] or 4
    begin, length = struct.unpack_from("<II", image, 0x248)
    packed = image[(sectors + 1) * 512 + begin:][:length]
    if packed[:6] != b"\xfd7zXZ\0":
        raise Failure(f"the kernel is compressed in a way that this does not know: {packed[:6].hex()}")
    return lzma.LZMADecompressor().decompress(packed)


KINDS = {
    "amd64": Kind(packages=("busybox-static", "udev", "libkmod2"),
                  modules=("usbhid", "hid_generic", "vhci_hcd", "virtio_net", *FOR_FILES, *FOR_DRIVES),
                  module_folders=("drivers/usb", "drivers/hid", "drivers/net", "net/core", *FOLDERS_FOR_FILES,
                                  *FOLDERS_FOR_DRIVES),
                  has_udev=True, kernel=uncompressed),
    "arm64": Kind(packages=("busybox-static",),
                  modules=("spi_gpio", *FOR_FILES), module_folders=("drivers/spi", *FOLDERS_FOR_FILES),
                  has_udev=False, kernel=lambda image: image),
}


def plain(name):
    return name.replace("-", "_")


def in_order(wanted, files):
    """`wanted` modules and all that they need, which come first. What has no file is part of the kernel."""
    order = []

    def add(name):
        file = files.get(plain(name))
        if file is None or file in order:
            return
        needed = re.search(rb"\0depends=([^\0]*)\0", file.read_bytes())
        for other in needed[1].decode().split(",") if needed else ():
            add(other)
        order.append(file)

    for name in wanted:
        add(name)
    return order


def place_modules(kind, unpacked, root):
    files = {plain(file.stem): file for file in unpacked.rglob("*.ko")}
    missing = {plain(name) for name in kind.modules} - files.keys()
    if missing:
        raise Failure(f"the kernel's package has no {', '.join(sorted(missing))}")
    folder = root / "lib/modules"
    folder.mkdir(parents=True)
    modules = in_order(kind.modules, files)
    for file in modules:
        shutil.copy(file, folder)
    (root / "modules").write_text("".join(f"{file.name}\n" for file in modules))


def place_program(file, root, libraries):
    """With the libraries that it needs, which may lie in the folder `libraries`."""
    shutil.copy(file, root / "bin")
    told = call("ldd", file, env={"LD_LIBRARY_PATH": str(libraries), "PATH": "/usr/bin:/bin"}).decode()
    if "not found" in told:
        raise Failure(f"{file.name} needs libraries that are not there:\n{told}")
    for library in re.findall(r"(?:=> |^\s*)(/\S+)", told, re.MULTILINE):
        folder = root / ("lib64" if "ld-linux" in library else "lib")
        folder.mkdir(exist_ok=True)
        shutil.copy(library, folder)


def make_root(kind, unpacked, root):
    (root / "bin").mkdir(parents=True)
    (root / "etc").mkdir()
    (root / "etc/group").write_text("root:x:0:\nplugdev:x:46:\n")
    (root / "etc/passwd").write_text("root:x:0:0::/:/bin/sh\n")
    shutil.copy(HERE / "init", root / "init")
    (root / "init").chmod(0o755)
    shutil.copy(unpacked / "bin/busybox", root / "bin/busybox")
    if kind.has_udev:
        place_program(unpacked / "bin/udevadm", root, unpacked / "lib/x86_64-linux-gnu")
        (root / "bin/systemd-udevd").symlink_to("udevadm")
    place_modules(kind, unpacked / "lib/modules", root)


def packed(root):
    names = "\n".join(sorted(str(path.relative_to(root)) for path in root.rglob("*")))
    return gzip.compress(call("cpio", "-o", "-H", "newc", "-R", "0:0", "--quiet", folder=root, input=names.encode()), 1)


def packages_for(architecture, work):
    return DebianPackages() if architecture == "amd64" else DebianPackages(work / "apt", architecture)


def make(folder, architecture):
    kind = KINDS[architecture]
    work = folder / "work"
    shutil.rmtree(work, ignore_errors=True)
    debian = packages_for(architecture, work)
    unpacked = work / "unpacked"
    for file in debian.download(work / "packages", debian.kernel(architecture), *kind.packages):
        if file.name.startswith("linux-image"):
            modules = (f"lib/modules/*/kernel/{part}/*" for part in kind.module_folders)
            unpack(file, unpacked, "boot/vmlinuz-*", *modules)
        else:
            unpack(file, unpacked)
    (kernel,) = (unpacked / "boot").glob("vmlinuz-*")
    (folder / "kernel").write_bytes(kind.kernel(kernel.read_bytes()))
    make_root(kind, unpacked, work / "root")
    (folder / "initrd.gz").write_bytes(packed(work / "root"))
    shutil.rmtree(work)


def main(folder, architecture="amd64"):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    stamp = folder / "made_of"
    makers = (HERE / "init", HERE / "make_guest.py", SCRIPTS / "debian_packages.py")
    made_of = "\n".join(maker.read_text(encoding="utf-8") for maker in makers)
    if stamp.is_file() and stamp.read_text(encoding="utf-8") == made_of:
        return
    stamp.unlink(missing_ok=True)
    make(folder, architecture)
    stamp.write_text(made_of, encoding="utf-8")
    print(f"{folder} has a guest for {architecture}")


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except Failure as failure:
        sys.exit(f"the guest cannot be made: {failure}")
