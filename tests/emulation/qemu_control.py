"""QEMU's control port, which speaks QMP."""

import json


class QemuControl:
    """`connection` is a socket that QEMU has just come to; `complaint` tells what QEMU has said when it is gone."""

    def __init__(self, connection, complaint=lambda: ""):
        self._port = connection.makefile("rwb", buffering=0)
        self._complaint = complaint
        json.loads(self._port.readline())
        self.command("qmp_capabilities")

    def command(self, name, **arguments):
        """What the command returns."""
        self._port.write(json.dumps({"execute": name, "arguments": arguments}).encode() + b"\n")
        while True:
            line = self._port.readline()
            if not line:
                raise EOFError(f"QEMU is gone: {self._complaint()}")
            answer = json.loads(line)
            if "error" in answer:
                raise RuntimeError(answer["error"])
            if "return" in answer:
                return answer["return"]
