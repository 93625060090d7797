#pragma once

#include "host/synfig/values/value.hpp"
#include "host/synfig/values/xml_file.hpp"

#include <optional>
#include <string_view>

namespace kfast::synfig {

// Seconds. Finite, so that transitions from and to them can be computed.
inline constexpr double begin_of_time = -1e7;
inline constexpr double end_of_time = 1e7;

/// The seconds of a time in the notation of files: "1s 12f", "2m", "36f", "SOT", "EOT"; a number without a
/// unit counts frames. Nothing if it is none of these.
std::optional<double> time_of(std::string_view text, double frame_rate);

/// Reads constants: plain values, and the attributes of others. Throws Failure where they are
/// damaged.
class ConstantReader {
public:
    ConstantReader(const XmlFile& file, double frame_rate) : file_{file}, frame_rate_{frame_rate} {}

    /// Whether an element of that name is a plain value.
    static bool knows(std::string_view kind);
    static bool is_true(pugi::xml_attribute attribute);

    /// Reads the element of a value; nothing if its kind has none that is used.
    Value read(pugi::xml_node element) const;
    double number(pugi::xml_node element, const char* attribute, double default_value) const;
    /// In seconds.
    double time(pugi::xml_node element, const char* attribute) const;

private:
    Value list(pugi::xml_node element) const;
    Gradient gradient(pugi::xml_node element) const;
    SplinePoint spline_point(pugi::xml_node element) const;
    WidthPoint width_point(pugi::xml_node element) const;
    Placement placement(pugi::xml_node element) const;
    double integer(pugi::xml_node element) const;
    double number_inside(pugi::xml_node element, double default_value) const;
    double number_of(std::string_view text, pugi::xml_node element) const;

    const XmlFile& file_;
    double frame_rate_;
};

}
