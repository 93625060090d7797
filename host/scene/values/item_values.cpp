#include "host/scene/values/item_values.hpp"

#include "core/math/angle.hpp"
#include "core/scene/kfb_limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kfast::scene {

namespace {

/// What `units` of a written number are stored as.
struct NumberForm {
    double stored;
    double units;
};

constexpr NumberForm pixels{16, 1};
constexpr NumberForm degrees{BinaryAngle::turn, 360};
constexpr NumberForm scales{kfb::max_scale, 64};
constexpr NumberForm shares{path_whole, 1};
constexpr NumberForm opacities{255, 1};
constexpr NumberForm dash_lengths{dash_pixel, 1};

std::optional<std::int32_t> read_form(const NumberForm& form, Range range, const kdl::Value& value,
                                      SceneContext& context)
{
    const auto number = read_number(value, range, context.report);
    if (!number)
        return std::nullopt;
    return static_cast<std::int32_t>(std::lround(*number * form.stored / form.units));
}

}

std::optional<std::int32_t> ItemValues::get(Property property) const
{
    const auto& value = own[static_cast<std::size_t>(property)];
    const bool is_scale = property == Property::scale_x || property == Property::scale_y;
    return is_scale && !value ? scale : value;
}

std::optional<std::int32_t> read_item_value(Property property, const kdl::Value& value, SceneContext& context)
{
    const Range range = kind_of(property).range;
    switch (property) {
    case Property::x:
    case Property::y:
    case Property::z:
    case Property::pivot_x:
    case Property::pivot_y:
        return read_form(pixels, range, value, context);
    case Property::rotation_x:
    case Property::rotation_y:
    case Property::rotation:
        return read_form(degrees, range, value, context);
    case Property::scale_x:
    case Property::scale_y:
        return read_form(scales, range, value, context);
    case Property::along:
    case Property::trim_from:
    case Property::trim_to:
    case Property::trim_offset:
        return read_form(shares, range, value, context);
    case Property::opacity:
        return read_form(opacities, range, value, context);
    case Property::order:
        return read_whole_number(value, range, context.report);
    case Property::visible:
        return read_flag(value, context.report);
    case Property::fill:
    case Property::stroke:
        return read_colour(value, context);
    case Property::width:
        return read_form(pixels, range, value, context);
    case Property::dash_offset:
    case Property::dash_1:
    case Property::gap_1:
    case Property::dash_2:
    case Property::gap_2:
    case Property::dash_3:
    case Property::gap_3:
        return read_form(dash_lengths, range, value, context);
    case Property::max_dashes:
        break; // found by the compiler
    case Property::trim_mode:
        if (const auto mode = read_word(value, trim_words, context.report))
            return static_cast<std::int32_t>(*mode);
    }
    return std::nullopt;
}

bool read_rotation(const kdl::Value& value, std::optional<std::int32_t>& rotation, SceneContext& context)
{
    if (rotation)
        return context.report.error(value.place, "rotate and rotate-z are the same and both given",
                                    "leave out one of them");
    return assign(read_item_value(Property::rotation, value, context), rotation);
}

namespace {

class Extent {
public:
    void add(int value)
    {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    std::int16_t centre() const { return static_cast<std::int16_t>((low_ + high_ + 1) >> 1); }

private:
    int low_ = std::numeric_limits<int>::max();
    int high_ = std::numeric_limits<int>::min();
};

struct Centre {
    Extent x;
    Extent y;

    void add(Point point)
    {
        x.add(point.x);
        y.add(point.y);
    }
};

Centre centre_of(const Drawing& drawing)
{
    Centre centre;
    for (const Stroke& stroke : drawing.strokes) {
        centre.add(stroke.from);
        for (const Segment& segment : stroke.segments)
            centre.add(segment.to);
    }
    return centre;
}

}

void set_default_pivot(const std::vector<Key>& keys, ItemValues& values)
{
    const auto is_seen = [](const Key& key) { return !key.drawing.strokes.empty(); };
    const auto first = std::ranges::find_if(keys, is_seen);
    if (first == keys.end())
        return;
    const Centre centre = centre_of(first->drawing);
    set_default_pivot({centre.x.centre(), centre.y.centre()}, values);
}

void set_default_pivot(Point pivot, ItemValues& values)
{
    auto& x = values[Property::pivot_x];
    auto& y = values[Property::pivot_y];
    x = x.value_or(pivot.x);
    y = y.value_or(pivot.y);
}

}
