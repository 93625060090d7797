#include "host/preview/painter/polygon_raster.hpp"

#include "host/preview/painter/area.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <cmath>
#include <freetype/freetype.h>
#include <freetype/ftoutln.h>
#include <vector>

namespace kfast {
namespace {

constexpr std::size_t max_corners = 1000; // FreeType counts them in short

/// FreeType has y up and counts in 1/64 pixel.
FT_Vector vector_of(WindowSpot spot)
{
    constexpr double farthest = 16000;
    const auto coordinate = [=](double value) {
        return static_cast<FT_Pos>(std::llround(std::clamp(value, -farthest, farthest) * 64));
    };
    return {coordinate(spot.x), -coordinate(spot.y)};
}

void take_spans(int y, int count, const FT_Span* spans, void* user)
{
    const auto& cover = *static_cast<const PolygonRaster::Cover*>(user);
    for (const FT_Span& span : std::span{spans, static_cast<std::size_t>(count)})
        cover(span.x, -1 - y, span.len, span.coverage);
}

}

struct PolygonRaster::Library {
    Library()
    {
        if (FT_Init_FreeType(&freetype) != 0)
            throw Failure("FreeType cannot be started");
    }
    ~Library() { FT_Done_FreeType(freetype); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

    FT_Library freetype = nullptr;
};

PolygonRaster::PolygonRaster() : library_{std::make_unique<Library>()} {}
PolygonRaster::~PolygonRaster() = default;

void PolygonRaster::trace(std::span<const WindowSpot> corners, Rect seen, const Cover& cover) const
{
    if (corners.size() < 3 || corners.size() > max_corners || is_empty(seen))
        return;
    std::vector<FT_Vector> points(corners.size());
    std::transform(corners.begin(), corners.end(), points.begin(), vector_of);
    std::vector<char> tags(corners.size(), FT_CURVE_TAG_ON);
    auto last = static_cast<short>(corners.size() - 1);
    FT_Outline outline{1, static_cast<short>(corners.size()), points.data(), tags.data(), &last, 0};
    FT_Raster_Params how{};
    how.flags = FT_RASTER_FLAG_AA | FT_RASTER_FLAG_DIRECT | FT_RASTER_FLAG_CLIP;
    how.gray_spans = take_spans;
    how.user = const_cast<Cover*>(&cover);
    how.clip_box = {seen.x, -bottom_of(seen), right_of(seen), -seen.y};
    FT_Outline_Render(library_->freetype, &outline, &how);
}

}
