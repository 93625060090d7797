#include "host/fit/board_reader.hpp"

#include "host/fit/display_reader.hpp"
#include "host/fit/quantity_reader.hpp"
#include "host/kdl/parser.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/property_rule.hpp"
#include "host/text/glyph.hpp"

#include <algorithm>
#include <vector>

namespace kfast::fit {
namespace {

using scene::assign, scene::NodeForm, scene::PropertyRule, scene::Range, scene::Reading, scene::Word;

constexpr Range clocks{1e6, 2e9};
constexpr Range bus_clocks{1e3, 1e9};
constexpr Range cycles{0.25, 20};
constexpr Range memories{1024, 64 * 1024 * 1024};
constexpr Range bands{16, 1024 * 1024};
constexpr Range reserves{0, 64 * 1024 * 1024};

constexpr std::array processor_words{
    Word<Processor>{"cortex-m0", Processor::cortex_m0}, Word<Processor>{"cortex-m0+", Processor::cortex_m0},
    Word<Processor>{"cortex-m3", Processor::cortex_m3}, Word<Processor>{"cortex-m4", Processor::cortex_m4},
    Word<Processor>{"cortex-m7", Processor::cortex_m7},
};

constexpr std::array bus_words{
    Word<BusKind>{"spi", BusKind::spi},
    Word<BusKind>{"parallel-8", BusKind::parallel_8},
    Word<BusKind>{"parallel-16", BusKind::parallel_16},
    Word<BusKind>{"i2c", BusKind::i2c},
};

bool read_bytes(const kdl::Value& value, Range range, std::size_t& bytes, Reading& reading)
{
    const auto quantity = read_quantity(value, memory_size, range, reading);
    if (quantity)
        bytes = static_cast<std::size_t>(*quantity);
    return quantity.has_value();
}

bool read_clock(const kdl::Value& value, Target& target, Reading& reading)
{
    return assign(read_quantity(value, frequency, clocks, reading), target.clock);
}

bool read_cycles(const kdl::Value& value, Target& target, Reading& reading)
{
    return assign(read_number(value, cycles, reading), target.cycles);
}

bool read_flash(const kdl::Value& value, Target& target, Reading& reading)
{
    return read_bytes(value, memories, target.flash, reading);
}

bool read_ram(const kdl::Value& value, Target& target, Reading& reading)
{
    return read_bytes(value, memories, target.ram, reading);
}

bool read_bus_clock(const kdl::Value& value, Target& target, Reading& reading)
{
    return assign(read_quantity(value, frequency, bus_clocks, reading), target.bus.clock);
}

bool read_reserved_flash(const kdl::Value& value, Target& target, Reading& reading)
{
    return read_bytes(value, reserves, target.reserved.flash, reading);
}

bool read_reserved_ram(const kdl::Value& value, Target& target, Reading& reading)
{
    return read_bytes(value, reserves, target.reserved.ram, reading);
}

constexpr std::array core_rules{
    PropertyRule<Target>{"clock", read_clock, true},
    PropertyRule<Target>{"cycles", read_cycles},
};
constexpr std::array memory_rules{
    PropertyRule<Target>{"flash", read_flash, true},
    PropertyRule<Target>{"ram", read_ram, true},
};
constexpr std::array bus_rules{PropertyRule<Target>{"clock", read_bus_clock, true}};
constexpr std::array reserved_rules{
    PropertyRule<Target>{"flash", read_reserved_flash},
    PropertyRule<Target>{"ram", read_reserved_ram},
};

bool read_core(const kdl::Node& node, Target& target, Reading& reading)
{
    const kdl::Value& name = node.arguments.front();
    const bool has_clock = read_properties(node, core_rules, target, reading);
    if (!assign(read_word(name, processor_words, reading), target.processor))
        return false;
    target.processor_name = *name.string();
    return has_clock;
}

bool read_memory(const kdl::Node& node, Target& target, Reading& reading)
{
    return read_properties(node, memory_rules, target, reading);
}

bool read_bus(const kdl::Node& node, Target& target, Reading& reading)
{
    const bool has_clock = read_properties(node, bus_rules, target, reading);
    return assign(read_word(node.arguments.front(), bus_words, reading), target.bus.kind) && has_clock;
}

bool read_panel(const kdl::Node& node, Target& target, Reading& reading)
{
    return assign(read_display(node, reading), target.display);
}

bool read_bands(const kdl::Node& node, Target& target, Reading& reading)
{
    return refuse_properties(node, reading) &&
           read_bytes(node.arguments.front(), bands, target.band_bytes, reading);
}

bool read_reserved(const kdl::Node& node, Target& target, Reading& reading)
{
    return read_properties(node, reserved_rules, target, reading);
}

/// What may stand in a board, once each.
struct PartRule {
    NodeForm form;
    bool (*read)(const kdl::Node& node, Target& target, Reading& reading);
    bool is_required = true;
};

constexpr std::array part_rules{
    PartRule{{"core", "core cortex-m0+ clock=(MHz)125", 1, 1}, read_core},
    PartRule{{"memory", "memory flash=(MiB)2 ram=(KiB)264"}, read_memory},
    PartRule{{"bus", "bus spi clock=(MHz)62.5", 1, 1}, read_bus},
    PartRule{{"panel", "panel st7789", 0, 3}, read_panel},
    PartRule{{"bands", "bands (KiB)4", 1, 1}, read_bands, false},
    PartRule{{"reserved", "reserved flash=(KiB)40 ram=(KiB)8"}, read_reserved, false},
};

void report_unknown_part(const kdl::Node& node, Reading& reading)
{
    std::vector<std::string_view> known;
    for (const PartRule& rule : part_rules)
        known.push_back(rule.form.name);
    reading.report.error(node.name_place, "a board has no node " + quoted(node.name),
                         suggestion(node.name, known));
}

const kdl::Node* only_part(const kdl::Node& board, const PartRule& rule, Reading& reading)
{
    const kdl::Node* part = nullptr;
    for (const kdl::Node& node : board.children) {
        if (node.name != rule.form.name)
            continue;
        if (part != nullptr)
            reading.report.error(node.name_place, "there is a " + node.name + " already, on " +
                                                      reading.report.line(part->name_place));
        part = &node;
    }
    if (part == nullptr && rule.is_required)
        reading.report.error(board.name_place, "this board has no " + std::string{rule.form.name},
                             "add \"" + std::string{rule.form.usage} + '"');
    return part;
}

void read_parts(const kdl::Node& board, Target& target, Reading& reading)
{
    for (const kdl::Node& node : board.children)
        if (std::ranges::none_of(part_rules,
                                 [&](const PartRule& rule) { return rule.form.name == node.name; }))
            report_unknown_part(node, reading);
    for (const PartRule& rule : part_rules)
        if (const kdl::Node* part = only_part(board, rule, reading))
            if (fits(*part, rule.form, reading))
                rule.read(*part, target, reading);
}

constexpr NodeForm board_form{"board", "board NAME { core …; memory …; bus …; panel … }", 1, 1, true};

void read_board(const kdl::Node& node, Target& target, Reading& reading)
{
    if (!fits(node, board_form, reading) || !refuse_properties(node, reading))
        return;
    if (const auto name = read_name(node.arguments.front(), reading))
        target.name = *name;
    read_parts(node, target, reading);
}

/// The only node there is.
const kdl::Node* board_node(const kdl::Document& document, Reading& reading)
{
    for (const kdl::Node& node : document.nodes)
        if (&node != &document.nodes.front() || node.name != board_form.name)
            reading.report.error(node.name_place, "a description of a board is one node",
                                 "write " + std::string{board_form.usage});
    if (document.nodes.empty())
        reading.report.error(Place{}, "there is no board in this text",
                             "write " + std::string{board_form.usage});
    return document.nodes.empty() ? nullptr : &document.nodes.front();
}

}

std::optional<Target> read_board(const SourceText& source, Diagnostics& diagnostics)
{
    const kdl::Document document = kdl::parse(source.text, diagnostics);
    if (diagnostics.has_errors())
        return std::nullopt;
    Reading reading{.report = {source, diagnostics}, .palette = {}, .fonts = scene::FontShelf{std::nullopt}};
    const kdl::Node* const node = board_node(document, reading);
    Target target;
    if (!diagnostics.has_errors())
        read_board(*node, target, reading);
    if (diagnostics.has_errors())
        return std::nullopt;
    return target;
}

}
