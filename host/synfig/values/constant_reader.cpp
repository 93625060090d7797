#include "host/synfig/values/constant_reader.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>

namespace kfast::synfig {

namespace {

std::string lower_without_blanks(std::string_view text)
{
    std::string result;
    for (const char letter : text)
        if (!std::isspace(static_cast<unsigned char>(letter)))
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return result;
}

std::optional<double> seconds_of(char unit, double frame_rate)
{
    switch (unit) {
    case 'h':
        return 3600;
    case 'm':
        return 60;
    case 's':
        return 1;
    case 'f':
        return 1 / frame_rate;
    default:
        return {};
    }
}

}

std::optional<double> time_of(std::string_view text, double frame_rate)
{
    const std::string compact = lower_without_blanks(text);
    if (compact == "sot" || compact == "bot")
        return begin_of_time;
    if (compact == "eot")
        return end_of_time;
    double total = 0;
    const char* at = compact.data();
    const char* const end = at + compact.size();
    while (at != end) {
        double amount = 0;
        const auto read = std::from_chars(at, end, amount);
        if (read.ec != std::errc{} || !std::isfinite(amount))
            return {};
        const auto unit = seconds_of(read.ptr == end ? 'f' : *read.ptr, frame_rate);
        if (!unit)
            return {};
        total += amount * *unit;
        at = read.ptr == end ? end : read.ptr + 1;
    }
    return std::isfinite(total) && !compact.empty() ? std::optional{total} : std::nullopt;
}

namespace {

constexpr double max_number = 1e9;

}

bool ConstantReader::knows(std::string_view kind)
{
    static constexpr std::string_view kinds[] = {
        "real",           "integer",  "angle",       "time",      "bool",           "vector",
        "color",          "string",   "bline_point", "list",      "transformation", "width_point",
        "bone_valuenode", "gradient", "segment",     "dash_item", "canvas",         "nil"};
    return std::ranges::find(kinds, kind) != std::end(kinds);
}

bool ConstantReader::is_true(pugi::xml_attribute attribute)
{
    const std::string_view text = attribute.value();
    return text == "true" || text == "1" || text == "TRUE" || text == "True";
}

Value ConstantReader::read(pugi::xml_node element) const
{
    const std::string_view kind = element.name();
    if (kind == "bool")
        return {is_true(element.attribute("value"))};
    if (kind == "real" || kind == "angle")
        return {number(element, "value", 0)};
    if (kind == "integer")
        return {integer(element)};
    if (kind == "time")
        return {time(element, "value")};
    if (kind == "string")
        return {std::string{element.text().get()}};
    if (kind == "vector")
        return {Vec2{number_inside(element.child("x"), 0), number_inside(element.child("y"), 0)}};
    if (kind == "color")
        return {Colour{number_inside(element.child("r"), 0), number_inside(element.child("g"), 0),
                       number_inside(element.child("b"), 0), number_inside(element.child("a"), 1)}};
    if (kind == "bline_point")
        return {spline_point(element)};
    if (kind == "width_point")
        return {width_point(element)};
    if (kind == "transformation")
        return {placement(element)};
    if (kind == "bone_valuenode")
        return {BoneName{element.attribute("guid").value()}};
    if (kind == "gradient")
        return {gradient(element)};
    if (kind == "list")
        return list(element);
    return {};
}

Gradient ConstantReader::gradient(pugi::xml_node element) const
{
    Gradient gradient;
    for (const pugi::xml_node child : element.children("color"))
        gradient.stops.push_back({std::clamp(number(child, "pos", 0), 0.0, 1.0), read(child).as<Colour>()});
    std::ranges::stable_sort(gradient.stops, {}, &GradientStop::position);
    return gradient;
}

Value ConstantReader::list(pugi::xml_node element) const
{
    List all{{}, is_true(element.attribute("loop"))};
    for (const pugi::xml_node child : element.children())
        if (child.type() == pugi::node_element && knows(child.name()))
            all.entries.push_back(read(child));
    return {std::move(all)};
}

SplinePoint ConstantReader::spline_point(pugi::xml_node element) const
{
    SplinePoint point;
    const auto spot = [&](const char* name) {
        return read(XmlFile::first_element(element.child(name))).as<Vec2>();
    };
    const auto real = [&](const char* name, double default_value) {
        return read(XmlFile::first_element(element.child(name))).number(default_value);
    };
    point.vertex = spot(element.child("vertex") ? "vertex" : "point");
    point.arriving = spot("t1");
    point.split_radius = point.split_angle = static_cast<bool>(element.child("t2"));
    point.second = point.split_angle ? spot("t2") : point.arriving;
    point.width = real("width", 1);
    point.origin = real("origin", 0.5);
    return point;
}

WidthPoint ConstantReader::width_point(pugi::xml_node element) const
{
    const auto real = [&](const char* name, double default_value) {
        return read(XmlFile::first_element(element.child(name))).number(default_value);
    };
    return {real("position", 0), real("width", 1), side_of(real("side_before", 0)),
            side_of(real("side_after", 0))};
}

Placement ConstantReader::placement(pugi::xml_node element) const
{
    const auto inner = [&](const char* name) { return read(XmlFile::first_element(element.child(name))); };
    return {inner("offset").as<Vec2>(), inner("angle").number(), inner("skew_angle").number(),
            inner("scale").as<Vec2>({1, 1})};
}

double ConstantReader::number(pugi::xml_node element, const char* attribute, double default_value) const
{
    const auto found = element.attribute(attribute);
    return found ? number_of(found.value(), element) : default_value;
}

/// Seeds of noise are as large as 32 bits go; nothing else is.
double ConstantReader::integer(pugi::xml_node element) const
{
    const std::string_view text = element.attribute("value").value();
    std::int64_t value = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
    if (parsed.ec != std::errc{} || parsed.ptr != text.data() + text.size())
        return number(element, "value", 0);
    return std::clamp(static_cast<double>(value), -max_number, max_number);
}

double ConstantReader::number_inside(pugi::xml_node element, double default_value) const
{
    return element ? number_of(element.text().get(), element) : default_value;
}

double ConstantReader::number_of(std::string_view text, pugi::xml_node element) const
{
    const std::string_view digits = text.substr(std::min(text.find_first_not_of(" \t\r\n+"), text.size()));
    double value = 0;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (parsed.ec != std::errc{} || !(std::abs(value) <= max_number))
        file_.fail(XmlFile::place(element), '"' + std::string{text} + "\" is no number below a billion");
    return value;
}

double ConstantReader::time(pugi::xml_node element, const char* attribute) const
{
    const std::string_view text = element.attribute(attribute).value();
    const auto found = time_of(text, frame_rate_);
    if (!found)
        file_.fail(XmlFile::place(element), '"' + std::string{text} + "\" is no time, such as \"1s 12f\"");
    return std::clamp(*found, begin_of_time, end_of_time);
}

}
