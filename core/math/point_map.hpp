#pragma once

#include "core/math/affine.hpp"

#include <cstdint>

namespace kfast {

/// An Affine made ready for many points: the same bits in fewer steps. Most only shift, and few lead so far
/// that 64 bits are needed.
class PointMap {
public:
    /// `map` must outlive this.
    explicit PointMap(const Affine& map);

    Point operator()(Point point) const;

    /// Whether points within 1024 px, or more, are moved by shift() and no more.
    bool is_shift() const { return kind_ == Kind::shift; }
    Point shift() const;

private:
    enum class Kind : std::uint8_t { shift, small, any };

    const Affine& map_;
    Kind kind_;
};

}
