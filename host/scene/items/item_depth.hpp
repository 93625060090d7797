#pragma once

#include "host/scene/context/symbol_table.hpp"
#include "host/scene/model.hpp"

#include <span>

namespace kfast::scene {

/// How deep groups and uses lie in each other among `items`, in which a Use has the number of an entry in
/// `symbols`, which has been read.
int depth_of(std::span<const Item> items, const SymbolTable& symbols);

}
