#pragma once

#include "host/art/losses.hpp"
#include "host/svg/style/style_sheet.hpp"

#include <cstddef>
#include <map>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace kfast::svg {

/// What holds for one element after all rules and what it inherits: the value of each property that is set.
class Style {
public:
    Style() = default;
    /// Of an element inside of one with the style `outer`: from attributes, rules of the sheet, and its own
    /// "style".
    Style(const Style& outer, pugi::xml_node element, StyleSheet& sheet);

    /// Of all values together.
    std::size_t bytes() const;

    /// Adds what the scene will not have of it, as losses of the layer.
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
