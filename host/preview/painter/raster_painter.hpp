#pragma once

#include "core/math/point.hpp"
#include "host/preview/painter/painter.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

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

    /// What it encloses twice is covered, too. Polygons of more than 1000 corners, and what is 16000 pixels
    /// away, are more than any window shows: they are left out.
    void trace(std::span<const WindowSpot> corners, Rect seen, const Cover& cover) const;

private:
    struct Library;
    std::unique_ptr<Library> library_;
};

/// How much of each pixel a letter covers, rows from the top; 255 is all.
struct LetterMask {
    Rect place; ///< from the left upper corner of the letter's cell
    std::vector<std::uint8_t> cover;
};

/// The letters of the preview's window, all as wide as Painter::letter.
class ScreenFont {
public:
    ScreenFont();
    ~ScreenFont();
    ScreenFont(const ScreenFont&) = delete;
    ScreenFont& operator=(const ScreenFont&) = delete;

    /// A box where the font has no such letter. Valid as long as the font.
    const LetterMask& letter(char32_t character);

private:
    class Face;
    std::unique_ptr<Face> face_;
};

/// Draws into memory: the same window on every computer, with and without a display.
class RasterPainter : public Painter {
public:
    /// Clears what was drawn; the sides are at least 1 pixel long.
    void begin(Size size);
    const Picture& drawn() const { return canvas_; }

    Size size() const override { return canvas_.size; }
    void fill(Rect area, Colour colour) override;
    void polygon(std::span<const WindowSpot> corners, Colour colour) override;
    void text(int x, int y, std::string_view text, Colour colour) override;
    void picture(const Picture& picture, Rect target) override;
    void clip(std::optional<Rect> area) override;

private:
    /// Draws pixels of a row, which may be outside.
    void cover(int x, int y, int width, std::uint8_t share, Colour colour);
    void letter(int x, int y, const LetterMask& mask, Colour colour);
    Colour* row(int y);

    Picture canvas_;
    Rect clip_;
    PolygonRaster raster_;
    ScreenFont font_;
};

}
