#include "host/simulator/controller_model.hpp"
#include "host/simulator/painted_frame.hpp"

namespace kfast {
namespace {

struct Place {
    int x;
    int y;
};

/// Where the pixel (x, y) of the upright picture lies on a glass of that size.
Place on_glass(Size glass, Rotation rotation, int x, int y)
{
    switch (rotation) {
    case Rotation::none:
        return {x, y};
    case Rotation::quarter:
        return {glass.width - 1 - y, x};
    case Rotation::half:
        return {glass.width - 1 - x, glass.height - 1 - y};
    case Rotation::three_quarters:
        return {y, glass.height - 1 - x};
    }
    return {x, y};
}

}

Frame seen_upright(const Frame& glass, Rotation rotation)
{
    const Size upright = lies_across(rotation) ? Size{glass.size.height, glass.size.width} : glass.size;
    Frame frame;
    with_format(*glass.format, [&]<PixelFormat format>() {
        constexpr bool is_dithered = format == PixelFormat::mono1_dithered;
        constexpr PixelFormat coding = is_dithered ? PixelFormat::mono1 : format;
        frame = painted_frame<coding>(upright, [&](int x, int y) {
            const Place place = on_glass(glass.size, rotation, x, y);
            return pixel_of<coding>(glass, place.x, place.y);
        });
    });
    frame.format = glass.format;
    return frame;
}

}
