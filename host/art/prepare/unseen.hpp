#pragma once

#include "host/art/document/document.hpp"

namespace kfast::art {

/// Takes out what is never seen: outlines without extent that show no dot, shapes that draw nothing or have
/// neither fill nor line, what is always transparent or never shown, and groups of nothing else.
void drop_unseen(Document& document);

}
