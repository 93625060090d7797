"""The tables of docs/benchmarks.md, by their headings, rows and columns."""


def cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def is_row(line):
    return line.startswith("|") and not set(line) <= set("|-: ")


def tables(page):
    """By the heading above each: of each row, by its first cell, the other cells by the heads of their columns."""
    found = {}
    heading, head = "", None
    for line in page.splitlines():
        if line.startswith("#"):
            heading = line.lstrip("# ").split(" (")[0]
        if not line.startswith("|"):
            head = None
        elif head is None:
            head = cells(line)[1:]
        elif is_row(line):
            name, *values = cells(line)
            found.setdefault(heading, {})[name] = dict(zip(head, values))
    return found


def number(cell, place=0):
    """One of the numbers of a cell such as "836,542 / 928,346"."""
    return float(cell.split(" / ")[place].replace(",", "").rstrip(" %"))
