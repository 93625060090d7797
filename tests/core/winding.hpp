#pragma once

#include "core/outline_store.hpp"

#include <cstddef>
#include <vector>

namespace kfast::test {

/// Contours in memory of their own, and how they go around a point.
class Contours {
public:
    explicit Contours(int rows = 4096) : storage_(1 << 20), store_{storage_, rows} {}

    OutlineStore& store() { return store_; }

    std::vector<Corner> corners() const
    {
        std::vector<Corner> all;
        for (std::uint16_t i = 0; i < store_.mark().end_corner; ++i)
            all.push_back(store_.corner(i));
        return all;
    }

    /// Around a point in pixels.
    int winding_at(double x, double y) const
    {
        int winding = 0;
        for (std::uint16_t i = 0; i < store_.mark().end_chain; ++i)
            if (const Chain& chain = store_.chain(i); passes_left_of(chain, x, y))
                winding += chain.winding();
        return winding;
    }

private:
    static double x_of(Corner corner) { return corner.x.raw() / 65536.0; }
    static double y_of(Corner corner) { return corner.y / 1024.0; }

    bool passes_left_of(const Chain& chain, double x, double y) const
    {
        for (int i = 0; i < chain.edges; ++i) {
            const int step = chain.runs_up != 0 ? -1 : 1;
            const Corner upper = store_.corner(chain.first + step * i);
            const Corner lower = store_.corner(chain.first + step * (i + 1));
            if (y >= y_of(upper) && y < y_of(lower))
                return x_of(upper) +
                           (x_of(lower) - x_of(upper)) * (y - y_of(upper)) / (y_of(lower) - y_of(upper)) <
                       x;
        }
        return false;
    }

    std::vector<std::byte> storage_;
    OutlineStore store_;
};

}
