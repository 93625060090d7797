#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"

#include <cstddef>

namespace kfast::art {

/// So many different cubic eases leave room among the 255 pairs of laws that a scene can have, for ways that
/// are divided when the text is written.
inline constexpr std::size_t max_eases = 160;

/// If a document has more different eases than that, rounds the controls of all of them to the finest of some
/// grids on which it has not, and adds a Loss.
void share_eases(Document& document, Losses& losses);

}
