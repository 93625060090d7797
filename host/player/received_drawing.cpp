#include "host/player/received_drawing.hpp"

#include "firmware/link/fields.hpp"
#include "firmware/link/input_message.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>

namespace kfast {

namespace {

constexpr std::string_view blanks = " \t\r\n";
constexpr double farthest = 2047; ///< px

std::string_view next_word(std::string_view& text)
{
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view word =
        text.starts_with('/') ? text.substr(0, 1) : text.substr(0, text.find_first_of(" \t\r\n/"));
    text.remove_prefix(word.size());
    return word;
}

std::optional<std::int16_t> read_coordinate(std::string_view text)
{
    double pixels = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), pixels);
    const bool is_whole = error == std::errc{} && rest == text.data() + text.size();
    if (!is_whole || !(std::abs(pixels) <= farthest))
        return std::nullopt;
    return static_cast<std::int16_t>(std::lround(pixels * 16));
}

std::optional<InputPoint> read_point(std::string_view word)
{
    const std::size_t comma = word.find(',');
    if (comma == std::string_view::npos)
        return std::nullopt;
    const auto x = read_coordinate(word.substr(0, comma));
    const auto y = read_coordinate(word.substr(comma + 1));
    return x && y ? std::optional{InputPoint{*x, *y}} : std::nullopt;
}

}

std::variant<ReceivedDrawing, std::string> read_drawing(std::string_view text)
{
    ReceivedDrawing drawing(1);
    for (std::string_view word = next_word(text); !word.empty(); word = next_word(text)) {
        if (word == "/") {
            drawing.emplace_back();
            continue;
        }
        const auto point = read_point(word);
        if (!point)
            return in_quotes(word) + " is no point: write it like 10,20.5, each within -2047 and 2047";
        drawing.back().push_back(*point);
    }
    std::erase_if(drawing, [](const std::vector<InputPoint>& stroke) { return stroke.empty(); });
    return drawing;
}

namespace {

/// The points as they are sent: strokes one after another, the pen lifted between them.
std::vector<InputPoint> wire_points(const ReceivedDrawing& drawing)
{
    std::vector<InputPoint> points;
    for (const std::vector<InputPoint>& stroke : drawing) {
        if (!points.empty())
            points.push_back(link::pen_up);
        points.insert(points.end(), stroke.begin(), stroke.end());
    }
    return points;
}

}

std::vector<Report> drawing_reports(const ReceivedDrawing& drawing, std::uint8_t input, std::uint8_t number,
                                    std::uint8_t tag)
{
    const std::vector<InputPoint> points = wire_points(drawing);
    const link::DrawingNumber which{input, static_cast<std::uint8_t>(number % link::DrawingNumber::count)};
    std::vector<Report> reports;
    std::span<const InputPoint> left = points;
    for (; left.size() > link::Drawing::max; left = left.subspan(link::Points::max)) {
        link::Points part{.which = which.code(), .part = static_cast<std::uint8_t>(reports.size())};
        static_assert(link::Points::max == link::Drawing::max + 1); // so all that remains fits into it
        std::ranges::copy(left.first(link::Points::max), part.points.begin());
        reports.push_back(link::report_of(part, tag));
    }
    link::Drawing last{.which = which.code(),
                       .part = static_cast<std::uint8_t>(reports.size()),
                       .count = static_cast<std::uint16_t>(points.size())};
    std::ranges::copy(left, last.points.begin());
    reports.push_back(link::report_of(last, tag));
    return reports;
}

}
