#include "firmware/board_record.hpp"
#include "firmware/board_rules.hpp"
#include "host/config/config_reader.hpp"
#include "host/config/config_text.hpp"

#include <cstdint>
#include <cstdlib>
#include <string>

using namespace kfast;

namespace {

void demand(bool condition)
{
    if (!condition)
        std::abort();
}

}

/// Any bytes at all: they are refused with messages that can be shown, or are settings that keep all rules
/// and come back from their text and their record.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const SourceText source{.name = "fuzz", .text = std::string(data, data + size)};
    Diagnostics diagnostics;
    const auto settings = config::read_config(source, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.sorted()) {
        demand(diagnostic.place.offset <= source.text.size());
        demand(!format(diagnostic, source).empty());
    }
    demand(settings.has_value() == !diagnostics.has_errors());
    if (!settings)
        return 0;

    demand(!first_mistake(*settings));
    Diagnostics again;
    demand(config::read_config({.name = "text", .text = config::config_text(*settings)}, again) == settings);
    demand(read_board_record(board_record(*settings)) == settings);
    return 0;
}
