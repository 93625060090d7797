#pragma once

#include "host/schema/node_words.hpp"

#include <string_view>
#include <vector>

namespace kfast::scene {

/// All that a scene may be written with, out of the very tables that its readers go by.
struct Vocabulary {
    std::vector<std::string_view> outermost; ///< ids of the nodes on the outermost level
    std::vector<schema::NodeWords> nodes;
    std::vector<schema::PropertyWords> quantities; ///< what a `track` may move
    std::vector<std::string_view> laws;            ///< as they are written: "hold", "steps(n)"
    std::vector<std::string_view> colours;         ///< that are known without a palette
    std::vector<std::string_view> fonts;           ///< that are part of the program
};

Vocabulary vocabulary();

/// The ids of the nodes that may hold the node `id`; the outermost level is "".
std::vector<std::string_view> holders(const Vocabulary& words, std::string_view id);

}
