#include "host/player/drawing_reports.hpp"

#include "firmware/link/fields.hpp"
#include "firmware/link/input_message.hpp"

#include <algorithm>
#include <span>

namespace kfast {
namespace {

/// As they go over the wire: strokes one after another, the pen lifted between them.
std::vector<LivePoint> wire_points(const ToldDrawing& drawing)
{
    std::vector<LivePoint> points;
    for (const std::vector<LivePoint>& stroke : drawing) {
        if (!points.empty())
            points.push_back(link::pen_up);
        points.insert(points.end(), stroke.begin(), stroke.end());
    }
    return points;
}

}

std::vector<link::Report> drawing_reports(const ToldDrawing& drawing, std::uint8_t input, std::uint8_t number,
                                          std::uint8_t tag)
{
    const std::vector<LivePoint> points = wire_points(drawing);
    const link::DrawingNumber which{input, static_cast<std::uint8_t>(number % link::DrawingNumber::count)};
    std::vector<link::Report> reports;
    std::span<const LivePoint> left = points;
    for (; left.size() > link::Drawing::most; left = left.subspan(link::Points::most)) {
        link::Points part{.which = which.code(), .part = static_cast<std::uint8_t>(reports.size())};
        static_assert(link::Points::most == link::Drawing::most + 1); // so all that is left fills it
        std::ranges::copy(left.first(link::Points::most), part.points.begin());
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
