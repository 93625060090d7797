#pragma once

#include "host/art/document/document.hpp"

#include <vector>

namespace kfast::scene_text {

/// When both are seen.
std::vector<art::Span> common(const std::vector<art::Span>& one, const std::vector<art::Span>& other);

}
