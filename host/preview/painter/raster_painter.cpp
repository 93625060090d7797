#include "host/preview/painter/raster_painter.hpp"

#include "core/bytes/code_point.hpp"
#include "host/fonts/dejavu_faces.hpp"
#include "host/preview/painter/painter.hpp"
#include "host/preview/painter/scaled_picture.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <cmath>
#include <freetype/freetype.h>
#include <freetype/ftoutln.h>
#include <map>
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

namespace {

constexpr FT_UInt em = 12; // pixels: letters are then as wide as Painter::letter
constexpr int baseline = 12;

LetterMask mask_of(const FT_GlyphSlotRec& glyph)
{
    const FT_Bitmap& bitmap = glyph.bitmap;
    const int width = static_cast<int>(bitmap.width);
    const int height = static_cast<int>(bitmap.rows);
    LetterMask mask{{glyph.bitmap_left, baseline - glyph.bitmap_top, width, height}, {}};
    for (int y = 0; y < height; ++y) {
        const unsigned char* row = bitmap.buffer + std::ptrdiff_t{y} * bitmap.pitch;
        mask.cover.insert(mask.cover.end(), row, row + width);
    }
    return mask;
}

}

/// Owns FreeType's objects.
class ScreenFont::Face {
public:
    Face()
    {
        const auto bytes = dejavu_sans_mono();
        if (FT_Init_FreeType(&library_) != 0)
            throw Failure("FreeType cannot be started");
        if (FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(bytes.data()),
                               static_cast<FT_Long>(bytes.size()), 0, &face_) != 0 ||
            FT_Set_Pixel_Sizes(face_, 0, em) != 0) {
            FT_Done_FreeType(library_);
            throw Failure("FreeType cannot read the font of the window");
        }
    }
    ~Face() { FT_Done_FreeType(library_); } // with the face
    Face(const Face&) = delete;
    Face& operator=(const Face&) = delete;

    const LetterMask& letter(char32_t character)
    {
        const auto [place, is_new] = letters_.try_emplace(character);
        if (is_new && FT_Load_Char(face_, character, FT_LOAD_RENDER) == 0)
            place->second = mask_of(*face_->glyph);
        return place->second;
    }

private:
    FT_Library library_ = nullptr;
    FT_Face face_ = nullptr;
    std::map<char32_t, LetterMask> letters_;
};

ScreenFont::ScreenFont() : face_{std::make_unique<Face>()} {}
ScreenFont::~ScreenFont() = default;

const LetterMask& ScreenFont::letter(char32_t character) { return face_->letter(character); }

namespace {

std::uint8_t mixed(int below, int above, int share)
{
    return static_cast<std::uint8_t>((below * (255 - share) + above * share + 127) / 255);
}

/// `share` of 255 of `above` is visible.
Colour mixed(Colour below, Colour above, int share)
{
    return {mixed(below.red, above.red, share), mixed(below.green, above.green, share),
            mixed(below.blue, above.blue, share)};
}

}

void RasterPainter::begin(Size size)
{
    canvas_.size = size;
    canvas_.pixels.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), {});
    clip(std::nullopt);
}

void RasterPainter::clip(std::optional<Rect> area)
{
    const Rect all{0, 0, canvas_.size.width, canvas_.size.height};
    clip_ = area ? common(*area, all) : all;
}

Colour* RasterPainter::row(int y) { return canvas_.pixels.data() + std::ptrdiff_t{y} * canvas_.size.width; }

void RasterPainter::cover(int x, int y, int width, std::uint8_t share, Colour colour)
{
    const Rect seen = common({x, y, width, 1}, clip_);
    if (is_empty(seen))
        return;
    const int all = (share * colour.opacity + 127) / 255;
    colour.opacity = 255;
    Colour* const first = row(y) + seen.x;
    if (all == 255)
        std::fill_n(first, seen.width, colour);
    else
        std::transform(first, first + seen.width, first,
                       [&](Colour below) { return mixed(below, colour, all); });
}

void RasterPainter::fill(Rect area, Colour colour)
{
    const Rect seen = common(area, clip_);
    for (int y = seen.y; y < bottom_of(seen); ++y)
        cover(seen.x, y, seen.width, 255, colour);
}

void RasterPainter::polygon(std::span<const WindowSpot> corners, Colour colour)
{
    raster_.trace(corners, clip_, [this, colour](int x, int y, int width, std::uint8_t share) {
        cover(x, y, width, share, colour);
    });
}

/// Draws only within its cell: what is beyond, at most an edge, would touch its neighbour.
void RasterPainter::letter(int x, int y, const LetterMask& mask, Colour colour)
{
    auto share = mask.cover.begin();
    for (int down = 0; down < mask.place.height; ++down)
        for (int right = 0; right < mask.place.width; ++right, ++share)
            if (contains({0, 0, Painter::letter.width, Painter::letter.height}, mask.place.x + right,
                         mask.place.y + down))
                cover(x + mask.place.x + right, y + mask.place.y + down, 1, *share, colour);
}

void RasterPainter::text(int x, int y, std::string_view text, Colour colour)
{
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = code_point_at(text, at);
        letter(x, y, font_.letter(point.value), colour);
        x += Painter::letter.width;
        at += point.length;
    }
}

void RasterPainter::picture(const Picture& picture, Rect target)
{
    const ScaledPicture scaled{picture, target};
    const Rect seen = common(target, clip_);
    for (int y = seen.y; y < bottom_of(seen); ++y)
        for (int x = seen.x; x < right_of(seen); ++x)
            row(y)[x] = scaled.at(x, y);
}

}
