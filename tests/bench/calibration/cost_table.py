"""host/fit/cost_table.cpp, as scripts/calibrate writes it."""

import textwrap

HEAD = """// Written by scripts/calibrate.

#include "host/fit/cost_table.hpp"
#include "host/fit/op_counts.hpp"

#include <array>
#include <string_view>

namespace kfast::fit {
namespace {

// What the costs below are of.
constexpr auto kinds = std::to_array<std::string_view>({
KINDS
});
static_assert(kinds == op_names, "the kinds of work have changed: scripts/calibrate");

constexpr std::array<ProcessorCosts, processor_count> table{{
"""

TAIL = """}};

}

const ProcessorCosts& costs_of(Processor processor) { return table[static_cast<std::size_t>(processor)]; }

}
"""


def row(cpu, costs, names):
    """`work` has a size of its own, which only converts to that of ProcessorCosts if there are as many kinds of work."""
    lines = [f"    // {cpu}", "    {", f"        .code = {costs.code},", f"        .bare_code = {costs.bare_code},",
             f"        .feature_code = {{{', '.join(str(code) for code in costs.feature_code)}}},", f"        .fixed_ram = {costs.fixed_ram},",
             f"        .stack = {costs.stack},", f"        .cycles = {costs.cycles:.2f},", f"        .frame = {costs.frame:.0f},",
             f"        .area = {costs.area:.0f},", "        .work =", "            std::to_array<double>({"]
    lines += [f"                {cost:.1f}, // {name}" for name, cost in zip(names, costs.work, strict=True)]
    return "\n".join(lines + ["            }),", "    },"]) + "\n"


def write_table(path, names, table):
    kinds = textwrap.fill(", ".join(f'"{name}"' for name in names) + ",", 108, initial_indent="    ", subsequent_indent="    ")
    rows = "".join(row(cpu, costs, names) for cpu, costs in table.items())
    path.write_text(HEAD.replace("KINDS", kinds) + rows + TAIL, encoding="utf-8")
