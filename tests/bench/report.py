"""The figures as docs/benchmarks.md shows them, beside those of others."""

import json
import pathlib

from scenes import REFERENCES

PEERS = json.loads(pathlib.Path(__file__).with_name("peers.json").read_text(encoding="utf-8"))
BEGIN, END = "<!-- figures: scripts/bench writes these -->\n", "<!-- end of figures -->\n"
GOALS = {"eyes": 45_000, "walker": 105_000, "morph": 95_000}


def write_into(document, results):
    """Replaces the figures between the two marks; the rest is written by hand."""
    text = document.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    document.write_text(before + BEGIN + "\n" + markdown(results) + "\n" + END + after, encoding="utf-8")


def markdown(results):
    sections = [frame_section(results), part_section(results)]
    sections += [peer_section(results, cpu) for cpu in ("cortex-m0", "cortex-m3", "cortex-m4")]
    sections += [image_section(results), block_section(results), sent_section(results), file_section(results),
                 host_section(results), f"Figures of others: {PEERS['source']}.\n"]
    return "\n".join(sections)


def section(title, header, rows):
    lines = [f"### {title}", "", row(header), row(["---"] + ["---:"] * (len(header) - 1))]
    return "\n".join(lines + [row(cells) for cells in rows]) + "\n"


def row(cells):
    return f"| {' | '.join(cells)} |"


def number(value):
    return "" if value is None else f"{value:,}"


def pair(figures):
    """Median and worst, of ours or of others."""
    if figures is None:
        return ""
    median, worst = (figures["median"], figures["worst"]) if isinstance(figures, dict) else figures
    return number(median) if worst is None else f"{number(median)} / {number(worst)}"


def triple(figures):
    return " / ".join(number(figures[name]) for name in ("median", "mean", "worst"))


def pretty(cpu):
    return cpu.replace("cortex-m", "Cortex-M")


def frame_section(results):
    counted = results["instructions"]
    rows = [[name] + [pair(counted[cpu].get(name)) for cpu in counted] for name in results["kfb_bytes"]]
    return section("Instructions in a frame, median / worst", ["scene"] + [pretty(cpu) for cpu in counted], rows)


def part_section(results):
    rows = [[name, pair(figures["update"]), pair(figures["draw"]), pair(figures["send"])]
            for name, figures in results["instructions"]["cortex-m0"].items()]
    return section("Parts of a frame on Cortex-M0, median / worst", ["scene", "update and edges", "fill", "send"], rows)


def peer_section(results, cpu):
    ours = results["instructions"][cpu]
    rows = [["**KFAST**"] + [pair(ours.get(name)) for name in REFERENCES]]
    if cpu == "cortex-m0":
        rows.append(["goal, median"] + [number(GOALS[name]) for name in REFERENCES])
    rows += [[peer["peer"]] + [pair(peer[cpu].get(name)) for name in REFERENCES]
             for peer in PEERS["instructions"] if cpu in peer]
    return section(f"Beside others on {pretty(cpu)}, instructions, median / worst", [""] + list(REFERENCES), rows)


def image_section(results):
    rows = [[name.replace("cortex-m", "Cortex-M") if name != pretty(name) and not name.startswith("lm3s") else name,
             number(flash), number(results["ram_bytes"][name]), number(results["stack_bytes"].get(name))]
            for name, flash in results["flash_bytes"].items()]
    rows += [[peer["peer"] + ", " + pretty(cpu), number(flash), "", number(peer["stack"])]
             for peer in PEERS["memory"] for cpu, flash in peer["flash"].items()]
    return section("Images: bytes", ["", "code and constants", "static RAM", "stack, deepest"], rows)


def block_section(results):
    rows = [["**KFAST**, the block that is lent"] + [number(results["ram_bytes"].get(name)) for name in REFERENCES]]
    rows += [[peer["peer"] + ", heap and canvas"] + [number(peer["ram"][name]) for name in REFERENCES]
             for peer in PEERS["memory"]]
    others = [name for name in results["kfb_bytes"] if name not in REFERENCES]
    return "\n".join([
        section("RAM for a scene at its own size, besides stack and bands: bytes", [""] + list(REFERENCES), rows),
        "The examples: " + ", ".join(f"{name} {number(results['ram_bytes'][name])}" for name in others) + ".\n"])


def sent_section(results):
    rows = [[name, triple(sent), triple(sent["least"]), ratio(sent), pair(sent["windows"])]
            for name, sent in results["sent_bytes"].items()]
    rows += [[f"{method}, of {name}", pair(figures[name]), "", "", ""]
             for method, figures in PEERS["sent"].items() for name in REFERENCES]
    return section("Bytes sent in a frame, median / mean / worst",
                   ["scene", "sent", "changed pixels alone", "ratio of means", "windows, median / worst"], rows)


def ratio(sent):
    least = sent["least"]["mean"]
    return f"{sent['mean'] / least:.2f}" if least else ""


def file_section(results):
    rows = [["**KFAST**, `.kfb`"] + [number(results["kfb_bytes"].get(name)) for name in REFERENCES]]
    rows += [[kind] + [number(sizes[name]) for name in REFERENCES] for kind, sizes in PEERS["files"].items()]
    others = [name for name in results["kfb_bytes"] if name not in REFERENCES]
    return "\n".join([
        section("Files: bytes", [""] + list(REFERENCES), rows),
        "The examples: " + ", ".join(f"{name} {number(results['kfb_bytes'][name])}" for name in others) + ".\n"])


def host_section(results):
    counted = {name: figures["instructions"] for name, figures in results["host"].items()}
    rows = [["**KFAST**"] + [pair(counted.get(name)) for name in REFERENCES]]
    rows += [[peer["peer"]] + [pair(peer[name]) for name in REFERENCES] for peer in PEERS["host_instructions"]]
    return section("On a PC (x86-64), instructions in a frame, median / worst", [""] + list(REFERENCES), rows)
