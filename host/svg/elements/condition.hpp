#pragma once

#include <pugixml.hpp>
#include <string>

namespace kfast::svg {

/// The attribute with its value, "systemLanguage "fr"", by which an element is not drawn here: scenes are
/// made for those who read English, and kfast has no extensions of SVG. Empty where nothing is in the way.
std::string unmet_condition(pugi::xml_node element);

}
