#pragma once

#include "host/art/document/document.hpp"
#include "host/kdl/document.hpp"
#include "host/scene_text/values/writing.hpp"

#include <vector>

namespace kfast::scene_text {

/// Gives an end to symbols that go on for longer than what is around them: keys that they have then would be
/// beyond it.
void end_symbols(art::Document& document);

/// Names the symbols that the document uses, also through others. Before item_nodes().
void name_symbols(const art::Document& document, Writing& writing);

/// The nodes `symbol` of those that have a name.
std::vector<kdl::Node> symbol_nodes(const art::Document& document, Writing& writing);

}
