#pragma once

#include "host/picture/picture.hpp"

#include <cstdint>
#include <optional>
#include <set>
#include <vector>

namespace kfast {

/// The colours of some pictures, in the order of 0xRRGGBB.
class Palette {
public:
    static constexpr std::size_t max = 256;

    /// False when they would become more than `max`; then the palette is of no use.
    bool add(const Picture& picture);

    std::vector<Colour> colours() const;
    /// Every pixel as an index into colours(). All of them must have been added.
    std::vector<std::uint8_t> indices(const Picture& picture) const;

private:
    std::set<std::uint32_t> words_;
};

/// A picture with a palette of its own.
struct IndexedPicture {
    std::vector<Colour> colours;
    std::vector<std::uint8_t> indices;
};

/// Exact for at most 256 colours, else the nearest of 256 that giflib chooses.
IndexedPicture indexed(const Picture& picture);

}
