"""Where the instructions of a scene go: the CPU's timer interrupts it every so many of them."""

import collections
import subprocess

from guest import image_for, play

INSTRUCTIONS_PER_SAMPLE = 1601 / 3.2  # Sampler::period_ticks
MOST_ROWS = 30


def print_profile(folder, cpu, scene):
    frames = play(folder, cpu, scene.compiled, profile=True).samples
    counts = collections.Counter(address for frame in frames for address in frame)
    places = source_places(image_for(folder, cpu), counts)
    unit = INSTRUCTIONS_PER_SAMPLE / len(frames)
    print(f"{scene.name} on {cpu}: {sum(counts.values()) * unit:,.0f} instructions per frame, mean of {len(frames)}")
    print_table("functions as compiled", counts, unit, lambda address: places[address][-1][0])
    print_table("functions as written, inlined ones apart", counts, unit, lambda address: places[address][0][0])
    print_table("lines", counts, unit, lambda address: places[address][0][1])


def print_table(title, counts, unit, name_of):
    rows = collections.Counter()
    for address, count in counts.items():
        rows[name_of(address)] += count
    print(f"\n{title}\n  per frame  share")
    for name, count in rows.most_common(MOST_ROWS):
        print(f"{count * unit:11,.0f} {100 * count / sum(counts.values()):5.1f}%  {name}")


def source_places(image, addresses):
    """For each address the functions that it lies in, each with its line: the innermost of the inlined ones first."""
    listing = subprocess.run(["arm-none-eabi-addr2line", "--addresses", "--functions", "--inlines", "--demangle",
                              "--exe", image], input="\n".join(map(hex, addresses)), check=True,
                             stdout=subprocess.PIPE, text=True, timeout=120).stdout
    places = {}
    lines = iter(listing.splitlines())
    for line in lines:
        if line.startswith("0x"):
            chain = places[int(line, 16)] = []
        else:
            chain.append((short_name(line), next(lines).split(" ")[0].rsplit("/", 1)[-1]))
    return places


def short_name(function):
    """Without namespaces of ours and without parameters."""
    name = function.replace("(anonymous namespace)::", "").replace("kfast::", "")
    depth = 0
    for place, letter in enumerate(name):
        depth += (letter == "<") - (letter == ">")
        if letter == "(" and depth == 0 and not name.endswith("operator", 0, place):
            return name[:place]
    return name
