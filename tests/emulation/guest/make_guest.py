"""Makes the kernel and the first file system of a Linux guest, from Debian's packages:

    make_guest.py <folder>

They go to <folder>/vmlinux and <folder>/initrd.gz; nothing is done when they are there. No rights are needed, nothing is
installed: apt downloads the packages, for which it must know them (apt-get update)."""

import gzip
import lzma
import pathlib
import re
import shutil
import struct
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
OTHER_PACKAGES = ("busybox-static", "udev", "libkmod2")
MODULES = ("usbhid", "hid_generic", "vhci_hcd", "virtio_pci", "virtio_net", "9p", "9pnet_virtio")
MODULE_FOLDERS = ("drivers/usb", "drivers/hid", "drivers/virtio", "drivers/net", "net/core", "net/9p", "fs/9p",
                  "fs/netfs", "fs/fscache")


class Failure(Exception):
    pass


def call(*command, folder=None, **options):
    done = subprocess.run([str(word) for word in command], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          check=False, **options)
    if done.returncode != 0:
        raise Failure(f"{' '.join(map(str, command))}: {done.stderr.decode(errors='replace').strip()}")
    return done.stdout


def wanted_packages():
    """As PACKAGE=VERSION. The kernel's name changes with its versions, so another package tells it."""
    told = subprocess.run(["apt-cache", "depends", "linux-image-amd64"], stdout=subprocess.PIPE, text=True, check=False)
    kernel = re.search(r"Depends: (linux-image-\S+)", told.stdout)
    if not kernel:
        raise Failure("apt does not know Debian's kernel, which the guest needs: run apt-get update, as scripts/install"
                      " does, on a Debian 12 for amd64")
    packages = (kernel[1], *OTHER_PACKAGES)
    policy = call("apt-cache", "policy", *packages).decode()
    versions = re.findall(r"^(\S+):\n.*\n  Candidate: (\S+)", policy, re.MULTILINE)
    if [name for name, _ in versions] != list(packages):
        raise Failure(f"apt does not know all of {', '.join(packages)}: run apt-get update, as scripts/install does")
    return [f"{name}={version}" for name, version in versions]


def unpack(package, folder, *patterns):
    """The files of a package that fit any of `patterns`."""
    archive = call("dpkg-deb", "--fsys-tarfile", package)
    folder.mkdir(exist_ok=True)
    call("tar", "-x", "-C", folder, "--wildcards", *(f"./{pattern}" for pattern in patterns), input=archive)


def uncompressed(image):
    """The ELF file within a bzImage, which starts faster: see the kernel's Documentation/x86/boot.rst."""
    sectors = image[0x1F1] or 4
    begin, length = struct.unpack_from("<II", image, 0x248)
    packed = image[(sectors + 1) * 512 + begin:][:length]
    if packed[:6] != b"\xfd7zXZ\0":
        raise Failure(f"the kernel is compressed in a way that this does not know: {packed[:6].hex()}")
    return lzma.LZMADecompressor().decompress(packed)


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


def place_modules(kernel, root):
    files = {plain(file.stem): file for file in kernel.rglob("*.ko")}
    modules = in_order(MODULES, files)
    missing = {plain(name) for name in MODULES if name.startswith(("usbhid", "vhci"))} - {plain(f.stem) for f in modules}
    if missing:
        raise Failure(f"the kernel's package has no {', '.join(missing)}")
    folder = root / "lib/modules"
    folder.mkdir(parents=True)
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


def make_root(unpacked, root):
    (root / "bin").mkdir(parents=True)
    (root / "etc").mkdir()
    (root / "etc/group").write_text("root:x:0:\nplugdev:x:46:\n")
    (root / "etc/passwd").write_text("root:x:0:0::/:/bin/sh\n")
    shutil.copy(HERE / "init", root / "init")
    (root / "init").chmod(0o755)
    shutil.copy(unpacked / "bin/busybox", root / "bin/busybox")
    place_program(unpacked / "bin/udevadm", root, unpacked / "lib/x86_64-linux-gnu")
    (root / "bin/systemd-udevd").symlink_to("udevadm")
    place_modules(unpacked / "lib/modules", root)


def packed(root):
    names = "\n".join(sorted(str(path.relative_to(root)) for path in root.rglob("*")))
    return gzip.compress(call("cpio", "-o", "-H", "newc", "-R", "0:0", "--quiet", folder=root, input=names.encode()), 1)


def make(folder, packages):
    work = folder / "work"
    shutil.rmtree(work, ignore_errors=True)
    (work / "packages").mkdir(parents=True)
    call("apt-get", "-q", "download", *packages, folder=work / "packages")
    unpacked = work / "unpacked"
    for file in (work / "packages").iterdir():
        if file.name.startswith("linux-image"):
            unpack(file, unpacked, "boot/vmlinuz-*", *(f"lib/modules/*/kernel/{part}/*" for part in MODULE_FOLDERS))
        else:
            call("dpkg-deb", "-x", file, unpacked)
    (kernel,) = (unpacked / "boot").glob("vmlinuz-*")
    (folder / "vmlinux").write_bytes(uncompressed(kernel.read_bytes()))
    make_root(unpacked, work / "root")
    (folder / "initrd.gz").write_bytes(packed(work / "root"))
    shutil.rmtree(work)


def main(folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    packages = wanted_packages()
    stamp = folder / "made_of"
    made_of = "\n".join([*packages, *((HERE / name).read_text(encoding="utf-8") for name in ("init", "make_guest.py"))])
    if stamp.is_file() and stamp.read_text(encoding="utf-8") == made_of:
        return
    stamp.unlink(missing_ok=True)
    make(folder, packages)
    stamp.write_text(made_of, encoding="utf-8")
    print("made of", *packages)


if __name__ == "__main__":
    try:
        main(*sys.argv[1:])
    except Failure as failure:
        sys.exit(f"the guest cannot be made: {failure}")
