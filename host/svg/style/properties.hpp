#pragma once

#include <string_view>

namespace kfast::svg {

enum class Care {
    read,     ///< the scene has it
    silent,   ///< nothing of the picture depends on it
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

/// A property of CSS, or an attribute that stands for one.
Property property_of(std::string_view name);

/// Whether an attribute of an element is understood, or has no effect on the picture.
bool is_known_attribute(std::string_view name);

}
