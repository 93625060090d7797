#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_profile.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Legs that follow each other in a circle.
class Tour {
public:
    Tour(const BeamLines& lines, std::span<BeamLeg> legs) : lines_{lines}, legs_{legs} {}

    std::size_t size() const { return legs_.size(); }
    FieldPoint begin_of(std::size_t place) const { return kfast::begin_of(lines_, legs_[place]); }
    FieldPoint end_of(std::size_t place) const { return kfast::end_of(lines_, legs_[place]); }
    std::size_t before(std::size_t place) const { return (place == 0 ? size() : place) - 1; }
    std::size_t behind(std::size_t place) const { return place + 1 == size() ? 0 : place + 1; }
    /// The travel from the leg before it.
    std::int32_t travel_to(std::size_t place) const
    {
        return beam_travel(end_of(before(place)), begin_of(place));
    }

    /// Reverses the order of the legs from `first` to `last`, and each of them.
    void reverse(std::size_t first, std::size_t last);
    /// Makes the leg at `place` the first one.
    void begin_at(std::size_t place)
    {
        std::rotate(legs_.begin(), legs_.begin() + static_cast<std::ptrdiff_t>(place), legs_.end());
    }
    /// Moves `count` legs from `first` on before the leg that was at `place`, which is not
    /// one of them, and may be size(). Returns where they begin now.
    std::size_t move(std::size_t first, std::size_t count, std::size_t place);

    /// The points at which a leg may begin; none for an open line.
    std::span<const FieldPoint> starts_of(std::size_t place) const;
    std::size_t start_of(std::size_t place) const { return legs_[place].start; }
    void set_start(std::size_t place, std::size_t start)
    {
        legs_[place].start = static_cast<std::uint16_t>(start);
    }

private:
    const BeamLines& lines_;
    std::span<BeamLeg> legs_;
};

/// How much effort is left for a route.
class RouteEffort {
public:
    explicit RouteEffort(std::uint32_t travels) : left_{travels} {}

    bool is_spent() const { return left_ == 0; }
    void spend(std::uint32_t travels) { left_ = travels < left_ ? left_ - travels : 0; }
    std::uint32_t left() const { return left_; }

private:
    std::uint32_t left_;
};

/// Makes `tour` shorter by small changes, each of which makes it shorter by itself: reverses a part
/// (2-opt), moves up to three legs elsewhere (Or-opt), begins closed lines at other points, of which not all
/// are looked at where there are many. Reversed parts and moves are at most `window` legs long. Ends where no
/// such change is left, or the effort.
void improve(Tour& tour, std::size_t window, RouteEffort& effort);

}
