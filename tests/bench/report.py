"""The figures as docs/benchmarks.md shows them, beside those of others."""

import json
import pathlib

from scenes import REFERENCES

PEERS = json.loads(pathlib.Path(__file__).with_name("peers.json").read_text(encoding="utf-8"))
BEGIN, END = "<!-- figures: scripts/bench writes these -->\n", "<!-- end of figures -->\n"
SPLIT = ("cortex-m0", "cortex-m4")
GOAL_CPU = "cortex-m0"
GOALS = {"eyes": 45_000, "walker": 105_000, "morph": 95_000}


def write_into(document, results):
    """Replaces the figures between the two marks; the rest is written by hand."""
    text = document.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    document.write_text(before + BEGIN + "\n" + markdown(results) + "\n" + END + after, encoding="utf-8")


def markdown(results):
    counted = results["instructions"]
    sections = [frame_section(counted, results["kfb_bytes"])]
    sections += [part_section(cpu, counted[cpu]) for cpu in counted if cpu in SPLIT]
    sections += [peer_section(cpu, counted[cpu]) for cpu in counted if any(cpu in peer for peer in PEERS["instructions"])]
    sections += [loading_section(results["loading"]), image_section(results), block_section(results),
                 sent_section(results), file_section(results), host_section(results)]
    if "pico" in results:
        sections += [pico_section(results["pico"]["scenes"]), pico_bus_section(results["pico"]["buses"])]
    sections += [f"Figures of others: {PEERS['source']}.\n"]
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


def frame_section(counted, names):
    rows = [[name] + [pair(counted[cpu].get(name)) for cpu in counted] for name in names]
    return section("Instructions in a frame, median / worst", ["scene"] + [pretty(cpu) for cpu in counted], rows)


def part_section(cpu, scenes):
    rows = [[name, pair(figures["update"]), pair(figures["draw"]), pair(figures["send"])]
            for name, figures in scenes.items()]
    return section(f"Parts of a frame on {pretty(cpu)}, median / worst", ["scene", "update and edges", "fill", "send"],
                   rows)


def peer_section(cpu, scenes):
    rows = [["**KFAST**"] + [pair(scenes.get(name)) for name in REFERENCES]]
    if cpu == GOAL_CPU:
        rows.append(["goal for the median"] + [number(GOALS[name]) for name in REFERENCES])
    rows += [[peer["peer"]] + [pair(peer[cpu].get(name)) for name in REFERENCES]
             for peer in PEERS["instructions"] if cpu in peer]
    return section(f"Beside others on {pretty(cpu)}, instructions in a frame, median / worst", [""] + list(REFERENCES),
                   rows)


def loading_section(loading):
    """What comes once: to check the scene, and with it until the first picture can be drawn."""
    names = [name for name in REFERENCES if any(name in scenes for scenes in loading.values())]
    rows = [[name] + [" / ".join(number(value) for value in scenes[name].values()) if name in scenes else ""
                      for scenes in loading.values()] for name in names]
    return section("Loading: instructions to check a scene, and with it until the first picture can be drawn",
                   ["scene"] + [pretty(cpu) for cpu in loading], rows)


def image_section(results):
    rows = [[image_name(name), number(flash), number(results["ram_bytes"][name]),
             number(results["stack_bytes"].get(name))] for name, flash in results["flash_bytes"].items()]
    rows += [[f"{peer['peer']}, {pretty(cpu)}", number(flash), "", number(peer["stack"])]
             for peer in PEERS["memory"] for cpu, flash in peer["flash"].items()]
    return section("Images: bytes", ["", "code and constants", "static RAM", "stack, deepest"], rows)


def image_name(name):
    """A CPU of the bench, or a board and its CPU."""
    board, _, cpu = name.rpartition("cortex")
    return f"{board.rstrip('-') or '**KFAST**, core and loop'}, {pretty('cortex' + cpu)}"


def block_section(results):
    blocks = {name: results["ram_bytes"].get(name) for name in results["kfb_bytes"]}
    rows = [["**KFAST**, the block that is lent"] + [number(blocks.get(name)) for name in REFERENCES]]
    rows += [[f"{peer['peer']}, heap and canvas"] + [number(peer["ram"][name]) for name in REFERENCES]
             for peer in PEERS["memory"]]
    return section("RAM for a scene at its own size, without stack and bands: bytes", [""] + list(REFERENCES),
                   rows) + examples(blocks)


def examples(figures):
    """One line for all scenes but the references."""
    others = [f"{name} {number(value)}" for name, value in figures.items() if name not in REFERENCES]
    return f"\nThe examples: {', '.join(others)}.\n" if others else ""


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
    return section("Files: bytes", [""] + list(REFERENCES), rows) + examples(results["kfb_bytes"])


def host_section(results):
    counted = {name: figures["instructions"] for name, figures in results["host"].items()}
    rows = [["**KFAST**"] + [pair(counted.get(name)) for name in REFERENCES]]
    rows += [[peer["peer"]] + [pair(peer[name]) for name in REFERENCES] for peer in PEERS["host_instructions"]]
    return section("On a PC (x86-64), instructions in a frame, median / worst", [""] + list(REFERENCES), rows)


def pico_section(scenes):
    rows = [[name, f"{figures['frames_per_second']}", f"{figures['late']} of {figures['shown'] + figures['late']}",
             percent(figures["bus_share"])] for name, figures in scenes.items()]
    return section("On a Pico (RP2040 at 125 MHz, ST7789 240 x 240 on SPI at 62.5 MHz), asked for 60 frames a second",
                   ["scene", "frames a second", "left out", "bus busy"], rows)


def pico_bus_section(buses):
    rows = [[name, f"{figures['bytes_per_second'] / 1e6:.2f}", percent(figures["bus_share"]),
             percent(figures["bus_share_when_all_changes"])] for name, figures in buses.items()]
    return section("Buses of a Pico, while a picture is sent whole",
                   ["bus", "MB/s", "busy, first picture", "busy, every pixel changes"], rows)


def percent(share):
    return f"{share:.1%}".replace("%", " %")
