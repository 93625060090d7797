"""The figures as build/bench/results.json keeps them, and what has grown since they were recorded."""

import statistics

PARTS = ("update", "draw", "send")
COMPARED = ("instructions", "loading", "flash_bytes", "ram_bytes", "stack_bytes", "kfb_bytes", "sent_bytes")
NOT_OURS = ("least",)
MOST_GROWTH = 0.02


def median(values):
    return int(statistics.median(values))


def mean(values):
    return round(statistics.mean(values))


def spread(values):
    return {"median": median(values), "mean": mean(values), "worst": max(values)}


def instruction_figures(frames):
    """Of a steady loop: the whole frame, and its parts apart."""
    figures = spread([sum(frame[part] for part in PARTS) for frame in frames])
    for part in PARTS:
        figures[part] = spread([frame[part] for frame in frames])
    return figures


def sent_figures(frames):
    """Bytes on the bus, commands included, beside the bytes of those pixels that changed."""
    figures = spread([frame["bytes"] for frame in frames])
    figures["windows"] = spread([frame["windows"] for frame in frames])
    figures["least"] = spread([frame["changed"] for frame in frames])
    return figures


def leaves(figures, path=()):
    """Every number that is compared, with its place."""
    for name, value in figures.items():
        if isinstance(value, dict):
            if name not in NOT_OURS:
                yield from leaves(value, path + (name,))
        else:
            yield path + (name,), value


def compared(figures):
    return dict(leaves({section: figures.get(section, {}) for section in COMPARED}))


def growth(recorded, measured):
    """Figures that are more than 2 % above those recorded, one line each."""
    before, now = compared(recorded), compared(measured)
    return [f"{'.'.join(place)}: {before[place]} -> {now[place]}{percent(before[place], now[place])}"
            for place in sorted(before.keys() & now.keys())
            if now[place] > before[place] * (1 + MOST_GROWTH)]


def percent(before, now):
    return f", {100 * (now / before - 1):+.1f} %" if before else ""
