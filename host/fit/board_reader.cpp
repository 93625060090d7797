#include "host/fit/board_reader.hpp"

#include "host/beam/beam_text.hpp"
#include "host/fit/display_reader.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/kdl/parser.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/value_reader.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <utility>

namespace kfast::fit {
namespace {

using schema::assign, schema::duration, schema::frequency, schema::memory_size, schema::NodeForm,
    schema::PartRule, schema::PropertyRule, schema::Range, schema::Report, schema::Times, schema::Word;

constexpr Range clocks{1e6, 2e9};
constexpr Range bus_clocks{1e3, 1e9};
constexpr Range cycles{0.25, 20};
constexpr Range memories{1024, 64 * 1024 * 1024};
constexpr Range bands{16, 1024 * 1024};
constexpr Range reserves{0, 64 * 1024 * 1024};
constexpr Range watchdogs{0.001, 1000};

constexpr std::array processor_words{
    Word<Processor>{"cortex-m0", Processor::cortex_m0}, Word<Processor>{"cortex-m0+", Processor::cortex_m0},
    Word<Processor>{"cortex-m3", Processor::cortex_m3}, Word<Processor>{"cortex-m4", Processor::cortex_m4},
    Word<Processor>{"cortex-m7", Processor::cortex_m7}, Word<Processor>{"cortex-m33", Processor::cortex_m33},
};

/// Whether the program has every feature of the player.
constexpr std::array feature_words{Word<bool>{"all", true}, Word<bool>{"needed", false}};

constexpr std::array bus_words{
    Word<BusKind>{"spi", BusKind::spi},
    Word<BusKind>{"parallel-8", BusKind::parallel_8},
    Word<BusKind>{"parallel-16", BusKind::parallel_16},
    Word<BusKind>{"i2c", BusKind::i2c},
    Word<BusKind>{"dac", BusKind::dac},
};

bool read_bytes(const kdl::Value& value, Range range, std::size_t& bytes, Report& report)
{
    const auto quantity = read_quantity(value, memory_size, range, report);
    if (quantity)
        bytes = static_cast<std::size_t>(*quantity);
    return quantity.has_value();
}

bool read_clock(const kdl::Value& value, Target& target, Report& report)
{
    return assign(read_quantity(value, frequency, clocks, report), target.clock);
}

bool read_cycles(const kdl::Value& value, Target& target, Report& report)
{
    return assign(read_number(value, cycles, report), target.cycles);
}

bool read_flash(const kdl::Value& value, Target& target, Report& report)
{
    return read_bytes(value, memories, target.flash, report);
}

bool read_ram(const kdl::Value& value, Target& target, Report& report)
{
    return read_bytes(value, memories, target.ram, report);
}

bool read_bus_clock(const kdl::Value& value, Target& target, Report& report)
{
    return assign(read_quantity(value, frequency, bus_clocks, report), target.bus.clock);
}

bool read_reserved_flash(const kdl::Value& value, Reserved& part, Report& report)
{
    return read_bytes(value, reserves, part.flash, report);
}

bool read_reserved_ram(const kdl::Value& value, Reserved& part, Report& report)
{
    return read_bytes(value, reserves, part.ram, report);
}

constexpr std::array core_rules{
    PropertyRule<Target>{"clock", read_clock, {}, true},
    PropertyRule<Target>{"cycles", read_cycles},
};
constexpr std::array memory_rules{
    PropertyRule<Target>{"flash", read_flash, {}, true},
    PropertyRule<Target>{"ram", read_ram, {}, true},
};
constexpr std::array bus_rules{PropertyRule<Target>{"clock", read_bus_clock, {}, true}};
constexpr std::array reserved_rules{
    PropertyRule<Reserved>{"flash", read_reserved_flash},
    PropertyRule<Reserved>{"ram", read_reserved_ram},
};

bool read_core(const kdl::Node& node, Target& target, Report& report)
{
    const kdl::Value& name = node.arguments.front();
    const bool has_clock = read_properties(node, core_rules, target, report);
    if (const auto hint = name.string() == nullptr ? std::nullopt : other_core_text(*name.string()))
        return report.error(name.place, "unknown core " + in_quotes(*name.string()), *hint);
    if (!assign(read_word(name, processor_words, report), target.processor))
        return false;
    target.processor_name = *name.string();
    return has_clock;
}

bool read_memory(const kdl::Node& node, Target& target, Report& report)
{
    return read_properties(node, memory_rules, target, report);
}

bool read_bus(const kdl::Node& node, Target& target, Report& report)
{
    const bool has_clock = read_properties(node, bus_rules, target, report);
    return assign(read_word(node.arguments.front(), bus_words, report), target.bus.kind) && has_clock;
}

bool read_panel(const kdl::Node& node, Target& target, Report& report)
{
    return assign(read_display(node, report), target.display);
}

bool read_board_beam(const kdl::Node& node, Target& target, Report& report)
{
    target.beam = read_beam(node, report);
    return target.beam.has_value();
}

bool read_bands(const kdl::Node& node, Target& target, Report& report)
{
    return refuse_properties(node, report) &&
           read_bytes(node.arguments.front(), bands, target.band_bytes, report);
}

bool read_reserved(const kdl::Node& node, Target& target, Report& report)
{
    Reserved part;
    if (!node.arguments.empty() && !assign(read_name(node.arguments.front(), report), part.name))
        return false;
    if (!read_properties(node, reserved_rules, part, report))
        return false;
    target.reserved.push_back(std::move(part));
    return true;
}

bool read_watchdog(const kdl::Node& node, Target& target, Report& report)
{
    return refuse_properties(node, report) &&
           assign(read_quantity(node.arguments.front(), duration, watchdogs, report), target.watchdog);
}

bool read_features(const kdl::Node& node, Target& target, Report& report)
{
    return refuse_properties(node, report) &&
           assign(read_word(node.arguments.front(), feature_words, report), target.has_every_feature);
}

constexpr NodeForm panel_form{"panel", "panel st7789", 0, 3};

constexpr std::array part_rules{
    PartRule<Target>{{"core", "core cortex-m0+ clock=(MHz)125", 1, 1}, read_core},
    PartRule<Target>{{"memory", "memory flash=(MiB)2 ram=(KiB)264"}, read_memory},
    PartRule<Target>{{"bus", "bus spi clock=(MHz)62.5", 1, 1}, read_bus},
    PartRule<Target>{panel_form, read_panel, Times::at_most_once},
    PartRule<Target>{beam_form, read_board_beam, Times::at_most_once},
    PartRule<Target>{{"bands", "bands (KiB)4", 1, 1}, read_bands, Times::at_most_once},
    PartRule<Target>{{"watchdog", "watchdog (s)8.3", 1, 1}, read_watchdog, Times::at_most_once},
    PartRule<Target>{{"features", "features all", 1, 1}, read_features, Times::at_most_once},
    PartRule<Target>{
        {"reserved", "reserved drivers flash=(KiB)40 ram=(KiB)8", 0, 1}, read_reserved, Times::any},
};

constexpr NodeForm board_form{"board", "board NAME { core …; memory …; bus …; panel … or beam … }", 1, 1,
                              true};

bool has_part(const kdl::Node& node, std::string_view name)
{
    return std::ranges::any_of(node.children, [name](const kdl::Node& part) { return part.name == name; });
}

/// Requires a panel, or a beam that a converter drives.
void require_display(const kdl::Node& node, const Target& target, Report& report)
{
    const bool has_beam = has_part(node, beam_form.name);
    if (!has_beam)
        require_part(panel_form, node, report);
    else if (has_part(node, panel_form.name))
        report.error(node.name_span, "this board has both a panel and a beam", "leave one of them out");
    if (target.bus.clock != 0 && has_beam != (target.bus.kind == BusKind::dac))
        report.error(node.name_span,
                     has_beam ? "a beam needs the bus of a converter" : "this bus has no panel",
                     has_beam ? "bus dac clock=(MHz)20" : "beam scope");
}

void read_board(const kdl::Node& node, Target& target, Report& report)
{
    if (!fits(node, board_form, report) || !refuse_properties(node, report))
        return;
    if (const auto name = read_name(node.arguments.front(), report))
        target.name = *name;
    read_parts(node, part_rules, target, report);
    require_display(node, target, report);
}

}

std::string_view word_of(BusKind kind)
{
    return std::ranges::find(bus_words, kind, &Word<BusKind>::meaning)->name;
}

std::optional<Target> read_board(const SourceText& source, Diagnostics& diagnostics)
{
    const kdl::Document document = kdl::parse(source.text, diagnostics);
    if (diagnostics.has_errors())
        return std::nullopt;
    Report report{source, diagnostics};
    Target target;
    if (const kdl::Node* const node = only_node(document, board_form, "a description of a board", report))
        read_board(*node, target, report);
    if (diagnostics.has_errors())
        return std::nullopt;
    return target;
}

}
