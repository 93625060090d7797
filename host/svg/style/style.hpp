#pragma once

#include "host/art/losses.hpp"
#include "host/svg/style/style_sheet.hpp"

#include <cstddef>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace kfast::svg {

enum class Care {
    read,     ///< the scene has it
    silent,   ///< it does not affect the picture
    reported, ///< a loss unless it is `default_value`
    unknown,
};

struct Property {
    std::string_view name;
    Care care = Care::unknown;
    bool inherited = false;
    std::string_view default_value = {}; ///< of what is reported: the value without effect
    std::string_view instead = {};       ///< of what is reported
};

/// A property of CSS, or an attribute that represents one.
Property property_of(std::string_view name);

/// Whether an attribute of an element is understood, or has no effect on the picture.
bool is_known_attribute(std::string_view name);

/// The computed style of one element, after rules and inheritance: the value of each set property.
class Style {
public:
    Style() = default;
    /// The style of an element inside of one with the style `outer`: from attributes, rules of the sheet, and
    /// its own "style".
    Style(const Style& outer, pugi::xml_node element, StyleSheet& sheet);

    /// The size of all values together.
    std::size_t bytes() const;

    /// Adds what the scene will not have as losses of the layer.
    void report(const std::string& layer, art::Losses& losses) const;

    /// Empty where it is not set.
    std::string_view operator[](std::string_view property) const;
    /// `default_value` where it is not set.
    std::string_view get(std::string_view property, std::string_view default_value) const;
    void set(const std::string& property, std::string_view value);

private:
    void put_in_custom_properties();

    std::map<std::string, std::string, std::less<>> values_;
};

}
