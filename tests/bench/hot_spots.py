"""Where the instructions of a scene go: the CPU's timer interrupts it every so many of them."""

import collections

from guest import image_for, play
from source_places import source_places

INSTRUCTIONS_PER_SAMPLE = 641 / 3.2  # Sampler::period_ticks
MOST_ROWS = 30


def print_profile(folder, cpu, scene, program="bench"):
    frames = play(folder, cpu, scene.compiled, profile=True, program=program).samples
    counts = collections.Counter(address for frame in frames for address in frame)
    places = source_places(image_for(folder, cpu, program), counts)
    unit = INSTRUCTIONS_PER_SAMPLE / len(frames)
    print(f"{scene.name} on {cpu}: {sum(counts.values()) * unit:,.0f} instructions per frame, mean of {len(frames)}")
    print_table("functions as compiled", counts, unit, lambda address: places[address][-1].function)
    print_table("functions as written, inlined ones apart", counts, unit, lambda address: places[address][0].function)
    print_table("lines", counts, unit, lambda address: f"{places[address][0].file}:{places[address][0].line}")


def print_table(title, counts, unit, name_of):
    rows = collections.Counter()
    for address, count in counts.items():
        rows[name_of(address)] += count
    print(f"\n{title}\n  per frame  share")
    for name, count in rows.most_common(MOST_ROWS):
        print(f"{count * unit:11,.0f} {100 * count / sum(counts.values()):5.1f}%  {name}")
