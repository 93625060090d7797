#pragma once

#include "core/scene/input_view.hpp"

#include <string>

namespace kfast {

/// Characters as glyphs= of an input takes them: "%0-9:". The space, which is always one of them, is left
/// out.
std::string glyph_text(const GlyphSet& glyphs);

}
