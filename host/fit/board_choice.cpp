#include "host/fit/board_choice.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "host/file/input_file.hpp"
#include "host/fit/board_reader.hpp"
#include "host/fit/board_texts.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/text/reported_diagnostics.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <vector>

namespace kfast::fit {

namespace {

constexpr InputKind board_input{"board", "a .kdl file", "a description begins with 'board'"};

Target board_of(const SourceText& source, std::ostream& out)
{
    Diagnostics diagnostics;
    const auto target = read_board(source, diagnostics);
    const std::size_t errors = report(diagnostics, source, out).errors;
    if (!target)
        throw Failure(source.name + ": " + counted(errors, "error"));
    return *target;
}

[[noreturn]] void refuse(const std::string& name)
{
    if (const auto advice = other_board_advice(name))
        throw Failure("there is no board " + in_quotes(name) + ": " + *advice);
    std::vector<std::string_view> known;
    std::ranges::transform(board_texts(), std::back_inserter(known), &BoardText::name);
    throw Failure("there is no board " + in_quotes(name) + ": " + suggestion(name, known) +
                  ", or name the file that describes it, like my-board.kdl");
}

}

bool names_board_file(const std::string& name) { return name.find_first_of("./") != name.npos; }

Target chosen_board(const std::string& name, std::ostream& out)
{
    if (names_board_file(name))
        return board_of({name, read_input(name, board_input)}, out);
    const auto built_in = std::ranges::find(board_texts(), name, &BoardText::name);
    if (built_in == board_texts().end())
        refuse(name);
    return board_of({name, std::string{built_in->text}}, out);
}

namespace {

BusKind kind_of(kfast::BusKind bus)
{
    switch (bus) {
    case kfast::BusKind::spi:
        return BusKind::spi;
    case kfast::BusKind::i2c:
        return BusKind::i2c;
    case kfast::BusKind::parallel_8:
        return BusKind::parallel_8;
    case kfast::BusKind::dac:
        break;
    }
    return {};
}

}

Target pico_target(const BoardSettings& settings)
{
    if (leads_beam(settings.bus)) {
        Target target = chosen_board("pico-xy");
        target.beam = settings.beam;
        target.bus.clock = settings.bus_clock;
        return target;
    }
    Target target = chosen_board("pico");
    target.display = *display_named(controller_name(settings.panel.controller));
    target.display.size = settings.panel.size();
    target.bus = {kind_of(settings.bus), static_cast<double>(settings.bus_clock)};
    return target;
}

}
