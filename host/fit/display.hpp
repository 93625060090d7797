#pragma once

#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::fit {

/// A panel, as far as it determines what is drawn and sent.
struct Display {
    std::string_view name = {};
    Size size;
    PixelFormat format = PixelFormat::rgb565;
    Size granularity{1, 1};        ///< positions and sizes of what is sent are multiples of this
    std::size_t window_bytes = 11; ///< commands that open a window
    double rated_spi = 0;          ///< Hz that the maker allows for writing; 0: not known
    bool is_driven = true;         ///< there is a driver for it: boards and the preview show it, too
};

/// The same display, with pixels of another format.
Display taking(PixelFormat format, Display display);

/// The controller of that name, or null.
const Display* display_named(std::string_view name);
/// All controllers that are known: those with a driver (firmware/settings/controller_facts.hpp), and some for
/// estimates alone.
std::span<const Display> displays();
/// The names of all of them.
std::vector<std::string_view> display_names();
/// The first one whose pixels have as many bits as those of `format`, or null.
const Display* display_like(PixelFormat format);
/// The hint for a name of no controller (host/text/suggestion.hpp).
std::string display_suggestion(std::string_view name);

}
