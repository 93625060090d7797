#pragma once

#include "host/preview/painter/painter.hpp"
#include "host/preview/painter/text_columns.hpp"

#include <string>
#include <vector>

namespace kfast::test {

/// Remembers what was drawn and where.
class RecordingPainter : public Painter {
public:
    struct Text {
        std::string text;
        Rect place;
        Colour colour;
    };
    struct Shape {
        std::vector<WindowSpot> corners;
        Colour colour;
    };
    struct Filled {
        Rect area;
        Colour colour;
    };

    explicit RecordingPainter(Size size) : size_{size} {}

    Size size() const override { return size_; }
    void fill(Rect area, Colour colour) override { fills.push_back({area, colour}); }
    void polygon(std::span<const WindowSpot> corners, Colour colour) override
    {
        shapes.push_back({{corners.begin(), corners.end()}, colour});
    }
    void text(int x, int y, std::string_view text, Colour colour) override
    {
        texts.push_back({std::string{text}, {x, y, columns_of(text) * letter.width, letter.height}, colour});
    }
    void picture(const Picture&, Rect target) override { pictures.push_back(target); }
    void clip(std::optional<Rect>) override {}

    /// Null if it was not written.
    const Text* find(std::string_view text) const
    {
        for (const Text& written : texts)
            if (written.text == text)
                return &written;
        return nullptr;
    }

    std::vector<Text> texts;
    std::vector<Shape> shapes;
    std::vector<Filled> fills;
    std::vector<Rect> pictures;

private:
    Size size_;
};

inline bool lies_within(Rect inner, Rect outer)
{
    return inner.x >= outer.x && inner.y >= outer.y && right_of(inner) <= right_of(outer) &&
           bottom_of(inner) <= bottom_of(outer);
}

/// From too small to use to larger than any screen in use.
inline std::vector<Size> window_sizes()
{
    return {{1, 1},     {7, 30},    {40, 300},  {300, 40},  {128, 64},
            {320, 240}, {619, 400}, {620, 400}, {900, 600}, {1920, 1080}};
}

}
