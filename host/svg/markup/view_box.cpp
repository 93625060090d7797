#include "host/svg/markup/view_box.hpp"

#include "host/svg/markup/length.hpp"

#include <algorithm>

namespace kfast::svg {
namespace {

/// Where along an axis the box lies that is smaller than its place: "xMinYMid", beside "xMin" and "xMid".
double share_before(std::string_view alignment, std::string_view min, std::string_view middle)
{
    if (alignment.find(min) != alignment.npos)
        return 0;
    return alignment.find(middle) != alignment.npos ? 0.5 : 1;
}

}

std::optional<ViewBox> view_box(std::string_view text)
{
    const auto values = numbers(text);
    if (values.size() != 4 || !(values[2] > 0) || !(values[3] > 0))
        return std::nullopt;
    return ViewBox{values[0], values[1], values[2], values[3]};
}

art::Affine fitted(const ViewBox& box, double width, double height, std::string_view aspect_ratio)
{
    double scale_x = width / box.width;
    double scale_y = height / box.height;
    if (aspect_ratio.empty())
        aspect_ratio = "xMidYMid";
    if (aspect_ratio.find("none") != aspect_ratio.npos)
        return art::grown(scale_x, scale_y) * art::moved(-box.x, -box.y);
    const bool slices = aspect_ratio.find("slice") != aspect_ratio.npos;
    scale_x = scale_y = slices ? std::max(scale_x, scale_y) : std::min(scale_x, scale_y);
    return art::moved(share_before(aspect_ratio, "xMin", "xMid") * (width - scale_x * box.width),
                      share_before(aspect_ratio, "YMin", "YMid") * (height - scale_y * box.height)) *
           art::grown(scale_x, scale_y) * art::moved(-box.x, -box.y);
}

}
