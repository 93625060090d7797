#pragma once

#include "host/art/losses.hpp"

#include <pugixml.hpp>
#include <string>

namespace kfast::svg {

/// The attribute with its value, "systemLanguage "fr"", that keeps an element from being drawn: scenes are
/// made for those who read English, and kfast has no extensions of SVG. Empty if there is none.
std::string unmet_condition(pugi::xml_node element);

/// Adds the loss of an element that is neither a shape nor a group, if leaving it out is visible.
void report_unread(pugi::xml_node element, const std::string& layer, art::Losses& losses);

/// The same for the content of an element that draws nothing of it: animations, for instance.
void report_content(pugi::xml_node element, const std::string& layer, art::Losses& losses);

/// Adds the losses of attributes that are not understood.
void report_attributes(pugi::xml_node element, const std::string& layer, art::Losses& losses);

}
