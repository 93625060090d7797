#pragma once

#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"

#include <string>
#include <vector>

namespace kfast {

/// What pixels of this format can show: "65536 colours", "16 greys", "black and white".
std::string colours_text(PixelFormat format);

/// A panel that some command knows by its name.
struct ListedPanel {
    std::string name;
    Size size;
    PixelFormat format;
    std::string bus;         ///< "spi, parallel"
    bool is_drawn = false;   ///< by --panel of render, preview and others that draw, and of kfast panel
    bool is_fitted = false;  ///< by kfast fit --panel
    bool is_flashed = false; ///< by kfast flash --panel
};

/// All of them, by name.
std::vector<ListedPanel> listed_panels();

}
