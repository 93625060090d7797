#include "host/fit/busy_drawing.hpp"

#include <algorithm>
#include <limits>
#include <random>

namespace kfast::fit {
namespace {

/// In 1/16 px.
struct Extent {
    int low = std::numeric_limits<int>::max();
    int high = std::numeric_limits<int>::min();

    void add(Fixed coordinate)
    {
        const int at = coordinate.raw() / (Fixed::one / 16);
        low = std::min(low, at);
        high = std::max(high, at);
    }
    Extent or_side(int pixels) const { return low < high ? *this : Extent{0, 16 * pixels}; }
    std::int16_t at(std::size_t part, std::size_t count) const
    {
        const auto way = static_cast<std::int64_t>(high - low) * static_cast<std::int64_t>(part);
        return static_cast<std::int16_t>(low +
                                         way / static_cast<std::int64_t>(std::max<std::size_t>(count, 1)));
    }
};

struct Box {
    Extent x;
    Extent y;

    void add(Point point)
    {
        x.add(point.x);
        y.add(point.y);
    }
};

Box box_of(const SceneView& scene, PackedDrawing drawing)
{
    Box box;
    for (std::uint32_t left = drawing.strokes(); left > 0; --left) {
        std::uint32_t segments = drawing.next_stroke();
        box.add(drawing.start());
        for (; segments > 0; --segments)
            box.add(drawing.next_segment().to);
    }
    return {box.x.or_side(scene.canvas().width), box.y.or_side(scene.canvas().height)};
}

/// Of one point after another, 0 … levels.
class Heights {
public:
    static constexpr std::size_t levels = 1000;

    Heights(Bustle bustle, int frame)
        : bustle_{bustle}, random_{static_cast<std::uint32_t>(frame)}, point_{static_cast<std::size_t>(frame)}
    {
    }

    std::size_t next()
    {
        if (bustle_ == Bustle::noise)
            return random_() % (levels + 1);
        const std::size_t phase = point_++ % wave;
        if (phase == 0)
            height_ = random_() % (levels + 1);
        return (levels - height_) / 2 + height_ * std::min(phase, wave - phase) / (wave / 2);
    }

private:
    static constexpr std::size_t wave = 8; ///< points

    Bustle bustle_;
    std::mt19937 random_;
    std::size_t point_;
    std::size_t height_ = levels / 2;
};

}

ReceivedDrawing busy_drawing(const SceneView& scene, std::uint32_t number, Bustle bustle, int frame)
{
    const DrawingInput limits = scene.input(number).drawing;
    const Box box = box_of(scene, scene.drawing(limits.default_value));
    Heights heights{bustle, frame};
    ReceivedDrawing drawing(limits.strokes);
    for (std::size_t point = 0; point < limits.points; ++point)
        drawing[point * limits.strokes / limits.points].push_back(
            {box.x.at(point, limits.points - 1), box.y.at(heights.next(), Heights::levels)});
    return drawing;
}

}
