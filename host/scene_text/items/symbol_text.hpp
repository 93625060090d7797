#pragma once

#include "host/art/document/document.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/values/writing.hpp"

#include <vector>

namespace kfast::scene_text {

/// Names the symbols that the document uses, also through others. Before item_nodes().
void name_symbols(const art::Document& document, Writing& writing);

/// The nodes `symbol` of those that have a name.
std::vector<kdl::Node> symbol_nodes(const art::Document& document, Writing& writing);

}
