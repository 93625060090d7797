#include "host/commands/text/clock_text.hpp"

#include "host/schema/quantity_reader.hpp"
#include "host/text/glyph.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

namespace kfast {
namespace {

constexpr double fastest_clock = 1e9;

}

std::uint32_t read_clock(const std::string& option, const std::string& text)
{
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
    const auto unit =
        std::ranges::find(schema::frequency_units, std::string_view{rest, end}, &schema::QuantityUnit::name);
    const double hz = unit == schema::frequency_units.end() ? 0 : number * unit->factor;
    if (error != std::errc{} || !(hz >= 1 && hz <= fastest_clock))
        throw CLI::ValidationError(option, "'" + visible(text) +
                                               "' is no clock: write it like 40MHz, 400kHz or 9600Hz");
    return static_cast<std::uint32_t>(std::lround(hz));
}

std::string clock_text(std::uint32_t hz)
{
    const auto unit = std::ranges::find_if(schema::frequency_units.rbegin(), schema::frequency_units.rend(),
                                           [hz](const auto& row) { return hz >= row.factor; });
    std::ostringstream text;
    text << hz / unit->factor << ' ' << unit->name;
    return text.str();
}

}
