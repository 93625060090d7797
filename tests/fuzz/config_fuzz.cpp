#include "core/bytes/crc32.hpp"
#include "firmware/settings/board_record.hpp"
#include "firmware/settings/board_rules.hpp"
#include "host/config/config_text.hpp"
#include "tests/demand.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

using namespace kfast;

namespace {

/// With the checksum of a record behind them.
std::vector<std::byte> sealed(std::span<const std::byte> bytes)
{
    Crc32 crc;
    crc.add(bytes);
    std::vector<std::byte> record(bytes.begin(), bytes.end());
    for (int shift = 0; shift < 32; shift += 8)
        record.push_back(static_cast<std::byte>(crc.value() >> shift));
    return record;
}

/// It is refused, or holds settings that may break rules and come back from a record of their own.
void check_record(std::span<const std::byte> bytes)
{
    const auto settings = read_board_record(bytes);
    if (!settings)
        return;
    demand(read_board_record(board_record(*settings)) == settings);
    demand(!config::config_text(*settings).empty());
    static_cast<void>(first_mistake(*settings));
}

void check_text(const SourceText& source)
{
    Diagnostics diagnostics;
    const auto settings = config::read_config(source, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.sorted()) {
        demand(diagnostic.place.offset <= source.text.size());
        demand(!format(diagnostic, source).empty());
    }
    demand(settings.has_value() == !diagnostics.has_errors());
    if (!settings)
        return;

    demand(!first_mistake(*settings));
    Diagnostics again;
    demand(config::read_config({.name = "text", .text = config::config_text(*settings)}, again) == settings);
    demand(read_board_record(board_record(*settings)) == settings);
}

}

/// Any bytes at all, as a record, as one without its checksum, and as a text. A text is refused with messages
/// that can be shown, or has settings that keep all rules and come back from their text and their record.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto bytes = std::as_bytes(std::span{data, size});
    check_record(bytes);
    check_record(sealed(bytes));
    check_text({.name = "fuzz", .text = std::string(data, data + size)});
    return 0;
}
