#include "host/player/drawing_reports.hpp"

#include "firmware/link/fields.hpp"
#include "firmware/link/input_message.hpp"

#include <algorithm>
#include <span>

namespace kfast {
namespace {

/// As they go over the wire: strokes one after another, the pen lifted between them.
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

std::vector<link::Report> drawing_reports(const ReceivedDrawing& drawing, std::uint8_t input,
                                          std::uint8_t number, std::uint8_t tag)
{
    const std::vector<InputPoint> points = wire_points(drawing);
    const link::DrawingNumber which{input, static_cast<std::uint8_t>(number % link::DrawingNumber::count)};
    std::vector<link::Report> reports;
    std::span<const InputPoint> left = points;
    for (; left.size() > link::Drawing::max; left = left.subspan(link::Points::max)) {
        link::Points part{.which = which.code(), .part = static_cast<std::uint8_t>(reports.size())};
        static_assert(link::Points::max == link::Drawing::max + 1); // so all that is left fills it
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
