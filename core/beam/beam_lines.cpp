#include "core/beam/beam_lines.hpp"

namespace kfast {

BeamLines::BeamLines(std::span<std::byte> storage)
    : points_{reinterpret_cast<FieldPoint*>(storage.data())},
      end_{reinterpret_cast<BeamLine*>(storage.data() + storage.size())},
      size_{storage.size()}
{
}

void BeamLines::clear()
{
    point_count_ = 0;
    line_count_ = 0;
    is_full_ = false;
}

void BeamLines::begin(Colour colour, std::uint32_t item)
{
    open_ = {static_cast<std::uint16_t>(point_count_), 0, colour, item};
}

void BeamLines::add(FieldPoint point)
{
    const bool is_new = open_.points == 0 || points_[point_count_ - 1] != point;
    if (!is_new || !has_capacity_for(sizeof(FieldPoint) + sizeof(BeamLine)))
        return;
    points_[point_count_++] = point;
    ++open_.points;
}

void BeamLines::end()
{
    if (open_.points == 0)
        return;
    ++line_count_;
    end_[-static_cast<std::ptrdiff_t>(line_count_)] = open_;
}

void BeamLines::drop()
{
    point_count_ = open_.first_point;
    open_.points = 0;
}

bool BeamLines::has_capacity_for(std::size_t bytes)
{
    is_full_ = is_full_ || point_count_ == max_points || used_bytes() + bytes > size_;
    return !is_full_;
}

}
