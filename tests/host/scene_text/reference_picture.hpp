#pragma once

#include "host/art/document/document.hpp"

#include <array>
#include <vector>

namespace kfast::test {

/// Channels of red, green and blue, 0 to 1, in rows from the top.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::array<double, 3>> pixels;
};

/// What a document looks like at a time: its fills, opaque or not at all, without lines, turns in space and
/// skins. Computed in doubles from the document itself, each pixel from many samples.
Picture reference_picture(const art::Document& document, double time);

}
