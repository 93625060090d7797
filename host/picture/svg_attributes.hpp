#pragma once

#include "core/math/fixed.hpp"
#include "core/math/projection.hpp"
#include "core/math/stroke_trimmer.hpp"
#include "core/pixel/paint_style.hpp"

#include <cstdio>
#include <string>

namespace kfast {

/// A length as SVG writes it, with at most four digits after the point: sixteenths are exact, the rest is
/// rounded to nearest, halves away from 0.
std::string svg_number(Fixed length);

/// 0 … 255 as 0 … 1, with at most four digits.
std::string svg_share(std::uint32_t opacity);

/// "#ff8000"; its opacity is left out.
inline std::string svg_colour(Colour colour)
{
    char text[16];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.red, colour.green, colour.blue);
    return text;
}

/// ` fill="#ff8000" fill-opacity="0.5"` for a property "fill" and a colour under an opacity of 0 … 255.
inline std::string paint_text(const std::string& property, Colour colour, std::uint32_t opacity)
{
    const std::uint32_t share = product_of_opacities(colour.opacity, opacity);
    const std::string paint = ' ' + property + "=\"" + svg_colour(colour) + '"';
    return share == 255 ? paint : paint + ' ' + property + "-opacity=\"" + svg_share(share) + '"';
}

/// Writes live strokes as the data of an SVG path, in pixels of the panel. PosedStrokes::trace() defines
/// begin(), add() and end().
class SvgPath {
public:
    enum class Use { fill, stroke };

    /// Curves stay curves, unless they are projected: then they become lines, for the projection of a curve
    /// is none.
    SvgPath(const Projection* projection, Use use)
        : is_projected_{projection != nullptr}, view_{projection, 0}, use_{use}
    {
    }

    void begin(Point from);
    void add(const Segment& segment);
    void end(Point hub, bool is_closed);
    // And for the pieces of a trimmed stroke (PieceSink).
    void end_piece(Point hub, PieceEnd end);
    int pieces_of(const Segment& segment) const { return view_.pieces_of(segment); }

    const std::string& data() const { return data_; }

private:
    void write(char command, Point at);
    void write(Point at);

    bool is_projected_;
    ViewProjection view_;
    Use use_;
    Point last_; ///< as the next two, before it is projected
    Point start_;
    std::string data_;
    std::size_t piece_begin_ = 0; ///< in `data_`
    std::string after_seam_;      ///< what the piece that ends at the seam goes on with
};

}
