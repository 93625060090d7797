#pragma once

#include "host/preview/painter/painter.hpp"
#include "host/preview/painter/polygon_raster.hpp"
#include "host/preview/painter/screen_font.hpp"

#include <cstdint>

namespace kfast {

/// Draws into memory: the same window on every computer, with and without a display.
class RasterPainter : public Painter {
public:
    /// Forgets what was drawn; the sides are at least 1 pixel long.
    void begin(Size size);
    const Picture& drawn() const { return canvas_; }

    Size size() const override { return canvas_.size; }
    void fill(Rect area, Colour colour) override;
    void polygon(std::span<const WindowSpot> corners, Colour colour) override;
    void text(int x, int y, std::string_view text, Colour colour) override;
    void picture(const Picture& picture, Rect target) override;
    void clip(std::optional<Rect> area) override;

private:
    /// Pixels of a row, which may lie outside.
    void cover(int x, int y, int width, std::uint8_t share, Colour colour);
    void letter(int x, int y, const LetterMask& mask, Colour colour);
    Colour* row(int y);

    Picture canvas_;
    Rect clip_;
    PolygonRaster raster_;
    ScreenFont font_;
};

}
