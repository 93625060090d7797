"""How many cycles an instruction of the player takes on average, from memory without wait states.

Which instructions are executed is sampled; what each takes is ARM's documentation of the cores: loads and stores of one word
2 cycles, of several one more for each, taken branches refill the pipeline. Half of the conditional ones count as taken. Of the
Cortex-M33 ARM publishes no such table: it counts as the Cortex-M4, whose pipeline has as many stages."""

import functools
import re
import subprocess

REFILL = {"cortex-m0": 2, "cortex-m3": 2, "cortex-m4": 2, "cortex-m7": 1, "cortex-m33": 2}
LONG_PRODUCT = {"cortex-m3": 4}  # cycles; 1 on the others
DIVISION = 7
LINE = re.compile(r"^\s*([0-9a-f]+):\t[0-9a-f ]+\t(\S+)(?:\t(.*))?$")


@functools.cache
def instructions(image):
    """Mnemonic and operands by address."""
    listing = subprocess.run(["arm-none-eabi-objdump", "-d", image], check=True, stdout=subprocess.PIPE, text=True,
                             timeout=120).stdout
    found = (LINE.match(line) for line in listing.splitlines())
    return {int(row[1], 16): (row[2].split(".")[0], row[3] or "") for row in found if row}


def registers(operands):
    """How many a list like {r4, r5-r7, pc} names."""
    count = 0
    for part in operands[operands.index("{") + 1:operands.index("}")].split(","):
        first, _, last = part.strip().partition("-")
        count += int(last[1:]) - int(first[1:]) + 1 if last else 1
    return count


def cycles(cpu, mnemonic, operands):
    refill = REFILL[cpu] if "pc" in operands and mnemonic.startswith(("pop", "ldm", "ldr", "mov", "add")) else 0
    if "{" in operands and mnemonic.startswith(("push", "pop", "ldm", "stm")):
        return 1 + registers(operands) + refill
    if mnemonic.startswith(("ldrd", "strd")):
        return 3
    if mnemonic.startswith(("ldr", "str")):
        return 2 + (0 if "[pc" in operands else refill)
    if mnemonic in ("b", "bl", "bx", "blx"):
        return 1 + REFILL[cpu]
    if re.fullmatch(r"b(eq|ne|cs|cc|mi|pl|vs|vc|hi|ls|ge|lt|gt|le)|cbn?z", mnemonic):
        return 1 + REFILL[cpu] / 2
    if mnemonic in ("smull", "umull", "smlal", "umlal"):
        return LONG_PRODUCT.get(cpu, 1)
    return DIVISION if mnemonic in ("sdiv", "udiv") else 1 + refill


def average(cpu, image, addresses):
    table = instructions(image)
    return sum(cycles(cpu, *table[address]) for address in addresses) / len(addresses)
