#include "core/beam/hatching.hpp"

#include "core/beam/beam_lines.hpp"

#include <algorithm>

namespace kfast {

namespace {

constexpr std::int64_t widest = 1 << 30;

/// The spacing between two lines, in 1/65536 px.
std::int32_t spacing_of(const BeamStyle& style, int wider)
{
    return static_cast<std::int32_t>(std::min((std::int64_t{style.spacing} << 12) << wider, widest));
}

}

Hatching::Hatching(std::span<std::byte> memory, const BeamStyle& style, int wider, int coarseness)
    : crossings_{reinterpret_cast<Crossing*>(memory.data())},
      max_{memory.size() / bytes_of_crossing},
      spacing_{spacing_of(style, wider)},
      direction_{cosine(style.direction), sine(style.direction)},
      view_{nullptr, coarseness}
{
}

void Hatching::begin(Point from) { start_ = last_ = from; }

void Hatching::add(const Segment& segment)
{
    flatten(segment, view_.pieces_of(segment), [this](Point to) { line_to(to); });
}

/// Closes strokes as FillOutline does.
void Hatching::end(Point hub, bool)
{
    line_to(hub);
    line_to(start_);
}

Hatching::Place Hatching::place(Point at) const
{
    const std::int32_t x = at.x.raw();
    const std::int32_t y = at.y.raw();
    const auto [cosine, sine] = direction_;
    return {multiply(x, cosine, 30) + multiply(y, sine, 30), multiply(y, cosine, 30) - multiply(x, sine, 30)};
}

Point Hatching::point(const Crossing& crossing) const
{
    const std::int32_t along = crossing.along;
    const std::int32_t across = across_of(crossing.line);
    const auto [cosine, sine] = direction_;
    return {Fixed::from_raw(multiply(along, cosine, 30) - multiply(across, sine, 30)),
            Fixed::from_raw(multiply(along, sine, 30) + multiply(across, cosine, 30))};
}

/// The number of the first line that is not before `across`.
std::int32_t Hatching::first_line_from(std::int32_t across) const
{
    const std::int32_t distance = across - spacing_ / 2;
    return distance / spacing_ + (distance % spacing_ > 0 ? 1 : 0);
}

/// A line through a corner is crossed where the border continues after it, so that the border crosses each
/// line as often upwards as downwards.
void Hatching::line_to(Point to)
{
    const bool is_up = place(to).across > place(last_).across;
    const Place low = place(is_up ? last_ : to);
    const Place high = place(is_up ? to : last_);
    last_ = to;
    const std::int32_t behind = first_line_from(high.across);
    for (std::int32_t line = first_line_from(low.across); line < behind && !is_full_; ++line)
        cross(line, low, high, is_up);
}

void Hatching::cross(std::int32_t line, Place low, Place high, bool is_up)
{
    if (count_ == max_) {
        is_full_ = true;
        return;
    }
    const std::int64_t height = std::int64_t{high.across} - low.across;
    const std::int64_t risen = std::int64_t{across_of(line)} - low.across;
    const std::int64_t width = std::int64_t{high.along} - low.along;
    const auto along = static_cast<std::int32_t>(low.along + width * risen / height);
    crossings_[count_++] = {line, (along & ~1) | (is_up ? 1 : 0)};
}

void Hatching::sort()
{
    const auto is_before = [](const Crossing& a, const Crossing& b) {
        if (a.line != b.line)
            return a.line < b.line;
        return a.line % 2 == 0 ? a.along < b.along : a.along > b.along;
    };
    std::make_heap(crossings_, crossings_ + count_, is_before);
    std::sort_heap(crossings_, crossings_ + count_, is_before);
}

namespace {

/// Pictures with more than this exceed every point clock.
constexpr std::size_t max_bytes = 65536;

class HatchingCount {
public:
    explicit HatchingCount(const SceneView& scene) : scene_{scene} {}

    std::size_t bytes() { return bytes_; }

    /// Recurses no deeper than groups and uses are nested, kfb::max_depth.
    void add(ItemCursor items)
    {
        while (!items.at_end() && bytes_ < max_bytes) {
            const ItemView item = items.next();
            if (!item.is_leaf())
                add(scene_.items_in(item));
            else if (item.beam.has_hatching())
                bytes_ = std::min(bytes_ + bytes_of(item.beam), max_bytes);
        }
    }

private:
    /// The size of the crossings and the piece between them (hatching.hpp).
    std::size_t bytes_of(const BeamStyle& style) const
    {
        constexpr std::size_t bytes_of_piece = 2 * 8 + sizeof(BeamLine);
        const int side = 16 * std::max(scene_.canvas().width, scene_.canvas().height);
        return static_cast<std::size_t>(side / style.spacing + 1) * bytes_of_piece;
    }

    const SceneView& scene_;
    std::size_t bytes_ = 0;
};

}

std::size_t hatching_bytes(const SceneView& scene)
{
    HatchingCount count{scene};
    count.add(scene.items());
    return count.bytes();
}

}
