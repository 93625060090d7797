#include "core/time/time.hpp"
#include "firmware/link/input_message.hpp"
#include "host/commands/live/live_line.hpp"
#include "host/player/received_drawing.hpp"
#include "host/program/failure.hpp"
#include "tests/demand.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

using namespace kfast;

namespace {

/// The space, and the digits with what follows them, up to the ":".
GlyphSet digits()
{
    static constexpr std::array<std::uint8_t, 10> bytes{12, 2, 0, ' ', 0, 0, 1, '0', 0, 0};
    ByteReader reader{std::as_bytes(std::span{bytes})};
    return GlyphSet::take(reader);
}

const std::vector<LiveInput> inputs{
    {"gaze", InputType::number, -1000, 1000},
    {"left lid", InputType::number, 0, 100'000},
    {"label", InputType::text, 0, 255},
    {"clock", InputType::text, 0, 5, digits()},
    {"plot", InputType::drawing},
};

InputType type_of(std::uint8_t input)
{
    demand(input < inputs.size());
    return inputs[input].type;
}

std::string text_of(const ReceivedDrawing& drawing)
{
    std::string text;
    for (const auto& stroke : drawing) {
        for (const InputPoint point : stroke)
            text += std::to_string(point.x / 16.0) + ',' + std::to_string(point.y / 16.0) + ' ';
        text += "/ ";
    }
    return text;
}

void demand_sense(const ReceivedDrawing& drawing)
{
    for (const auto& stroke : drawing) {
        demand(!stroke.empty());
        for (const InputPoint point : stroke)
            demand(std::max(std::abs(point.x), std::abs(point.y)) <= 2047 * 16);
    }
    demand(std::get<ReceivedDrawing>(read_drawing(text_of(drawing))) == drawing);
}

void demand_sense(const LiveValues& values)
{
    for (const auto& [input, place] : values.places)
        demand(type_of(input) == InputType::number && place >= Time{0} && place <= whole_input);
    for (const auto& [input, text] : values.texts)
        demand(type_of(input) == InputType::text && text.size() <= link::Text::max);
    for (const auto& [input, drawing] : values.drawings) {
        demand(type_of(input) == InputType::drawing);
        demand_sense(drawing);
    }
}

void check_line(std::string_view line, std::size_t number)
try {
    demand_sense(read_live_line(line, number, inputs));
} catch (const Failure& failure) {
    demand(std::string_view{failure.what()}.starts_with("line " + std::to_string(number) + ": "));
}

void check_drawing(std::string_view text)
{
    const auto read = read_drawing(text);
    if (const auto* const drawing = std::get_if<ReceivedDrawing>(&read))
        demand_sense(*drawing);
    else
        demand(!std::get<std::string>(read).empty());
}

}

/// Any bytes at all, as a drawing and as lines of live values: they are refused with a message, or are what
/// inputs can be. A drawing comes back from its text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(data, data + size);
    check_drawing(text);
    std::string_view rest = text;
    for (std::size_t number = 1; !rest.empty(); ++number) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        check_line(line, number);
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    }
    return 0;
}
