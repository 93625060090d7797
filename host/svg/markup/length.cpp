#include "host/svg/markup/length.hpp"

#include "host/geometry/path_scanner.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kfast::svg {

std::string shortened(std::string_view text, std::size_t max)
{
    if (text.size() <= max)
        return std::string{text};
    std::size_t end = max;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
        --end;
    return std::string{text.substr(0, end)} + "...";
}

namespace {

struct Unit {
    std::string_view name;
    double pixels;
};

/// The units of CSS, at 96 px to the inch.
constexpr std::array<Unit, 8> units{{{"", 1},
                                     {"px", 1},
                                     {"in", 96},
                                     {"cm", 96 / 2.54},
                                     {"mm", 96 / 25.4},
                                     {"Q", 96 / 101.6},
                                     {"pt", 96.0 / 72},
                                     {"pc", 16}}};

struct Quantity {
    double value;
    std::string_view unit;
};

std::optional<Quantity> quantity(std::string_view text)
{
    text = trimmed(text);
    scene::PathScanner scanner{text};
    const auto value = scanner.number();
    if (!value)
        return std::nullopt;
    return Quantity{*value, text.substr(scanner.offset())};
}

double whole(Axis axis, const Measure& measure)
{
    switch (axis) {
    case Axis::x:
        return measure.width;
    case Axis::y:
        return measure.height;
    case Axis::diagonal:
        break;
    }
    return std::sqrt((measure.width * measure.width + measure.height * measure.height) / 2);
}

}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view space = " \t\r\n\f";
    const std::size_t begin = text.find_first_not_of(space);
    if (begin == text.npos)
        return {};
    return text.substr(begin, text.find_last_not_of(space) + 1 - begin);
}

std::optional<double> length(std::string_view text, Axis axis, const Measure& measure)
{
    const auto found = quantity(text);
    if (!found)
        return std::nullopt;
    if (found->unit == "%")
        return found->value / 100 * whole(axis, measure);
    if (found->unit == "em")
        return found->value * measure.font_size;
    if (found->unit == "rem")
        return found->value * measure.root_font_size;
    if (found->unit == "ex" || found->unit == "ch")
        return found->value * measure.font_size / 2;
    const auto unit = std::ranges::find(units, found->unit, &Unit::name);
    if (unit == units.end())
        return std::nullopt;
    return found->value * unit->pixels;
}

std::optional<double> number(std::string_view text)
{
    const auto found = quantity(text);
    return found && found->unit.empty() ? std::optional{found->value} : std::nullopt;
}

std::optional<double> share(std::string_view text)
{
    const auto found = quantity(text);
    if (found && found->unit == "%")
        return found->value / 100;
    return number(text);
}

std::vector<double> numbers(std::string_view text)
{
    std::string_view rest;
    return numbers(text, rest);
}

std::vector<double> numbers(std::string_view text, std::string_view& rest)
{
    scene::PathScanner scanner{text};
    std::vector<double> result;
    scanner.skip_space();
    while (const auto value = scanner.number()) {
        result.push_back(*value);
        scanner.skip_separator();
    }
    rest = text.substr(scanner.offset());
    return result;
}

namespace {

/// Where along an axis a box is that is smaller than its area: "xMinYMid", beside "xMin" and "xMid".
double share_before(std::string_view alignment, std::string_view min, std::string_view middle)
{
    if (alignment.find(min) != alignment.npos)
        return 0;
    return alignment.find(middle) != alignment.npos ? 0.5 : 1;
}

}

std::optional<ViewBox> view_box(std::string_view text)
{
    const auto values = numbers(text);
    if (values.size() != 4 || !(values[2] > 0) || !(values[3] > 0))
        return std::nullopt;
    return ViewBox{values[0], values[1], values[2], values[3]};
}

art::Affine fitted(const ViewBox& box, double width, double height, std::string_view aspect_ratio)
{
    double scale_x = width / box.width;
    double scale_y = height / box.height;
    if (aspect_ratio.empty())
        aspect_ratio = "xMidYMid";
    if (aspect_ratio.find("none") != aspect_ratio.npos)
        return art::grown(scale_x, scale_y) * art::moved(-box.x, -box.y);
    const bool slices = aspect_ratio.find("slice") != aspect_ratio.npos;
    scale_x = scale_y = slices ? std::max(scale_x, scale_y) : std::min(scale_x, scale_y);
    return art::moved(share_before(aspect_ratio, "xMin", "xMid") * (width - scale_x * box.width),
                      share_before(aspect_ratio, "YMin", "YMid") * (height - scale_y * box.height)) *
           art::grown(scale_x, scale_y) * art::moved(-box.x, -box.y);
}

std::optional<double> reported_length(std::string_view name, std::string_view text, Axis axis,
                                      const Measure& measure, const std::string& layer, art::Losses& losses)
{
    text = trimmed(text);
    if (text.empty() || text == "auto")
        return std::nullopt;
    const auto value = length(text, axis, measure);
    if (!value)
        losses.add({std::string{name} + ": " + shortened(text), layer, {}, "it is as if it were not set"});
    return value ? std::optional{std::clamp(*value, -farthest, farthest)} : std::nullopt;
}

}
