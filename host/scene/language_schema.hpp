#pragma once

#include "host/schema/node_form.hpp"

#include <string_view>
#include <vector>

namespace kfast::scene {

/// All that a scene may be written with, from the same tables that its readers use.
struct LanguageSchema {
    std::vector<std::string_view> outermost; ///< ids of the nodes on the outermost level
    std::vector<schema::NodeSchema> nodes;
    std::vector<schema::PropertySchema> quantities; ///< what a `track` may animate
    std::vector<std::string_view> laws;             ///< as they are written: "hold", "steps(n)"
    std::vector<std::string_view> colours;          ///< that are known without a palette
    std::vector<std::string_view> fonts;            ///< that are part of the program
};

LanguageSchema language_schema();

/// The ids of the nodes that may hold the node `id`; the outermost level is "".
std::vector<std::string_view> holders(const LanguageSchema& words, std::string_view id);

}
