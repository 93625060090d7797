#pragma once

#include "host/preview/painter/painter.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace kfast {

/// Which pixels a polygon covers, and how much of each: FreeType's rasterizer for letters.
class PolygonRaster {
public:
    /// Pixels beside each other that are covered alike; 255 is all.
    using Cover = std::function<void(int x, int y, int width, std::uint8_t share)>;

    PolygonRaster();
    ~PolygonRaster();
    PolygonRaster(const PolygonRaster&) = delete;
    PolygonRaster& operator=(const PolygonRaster&) = delete;

    /// What it encloses twice is covered, too. Polygons of more than 1000 corners, and what lies 16000 pixels
    /// away, are more than any window shows: they are left out.
    void trace(std::span<const WindowSpot> corners, Rect seen, const Cover& cover) const;

private:
    struct Library;
    std::unique_ptr<Library> library_;
};

}
