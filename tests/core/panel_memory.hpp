#pragma once

#include "tests/core/filling.hpp"
#include "tests/core/player_fixture.hpp"

#include <cstring>
#include <doctest/doctest.h>

namespace kfast::test {

/// A panel's memory. It starts with rubbish in it.
template <PixelFormat format>
class PanelMemory {
public:
    explicit PanelMemory(Size size)
        : size_{size},
          bytes_(row_bytes(format, size.width) * static_cast<std::size_t>(size.height), std::byte{0x5A})
    {
    }

    void take(const Change& change)
    {
        const std::size_t width = row_bytes(format, change.area.width);
        REQUIRE(change.pixels.size() == width * static_cast<std::size_t>(change.area.height));
        for (int row = 0; row < change.area.height; ++row)
            std::memcpy(&bytes_.at(offset(change.area.x, change.area.y + row)),
                        change.pixels.data() + width * static_cast<std::size_t>(row), width);
        bytes_ = without_filling(format, size_, bytes_);
    }

    const Bytes& bytes() const { return bytes_; }

private:
    std::size_t offset(int x, int y) const
    {
        return row_bytes(format, size_.width) * static_cast<std::size_t>(y) + row_bytes(format, x);
    }

    Size size_;
    Bytes bytes_;
};

struct Sent {
    std::size_t areas = 0;
    std::size_t bytes = 0;
};

/// Draws what changes, with room for `rows` rows at once.
template <PixelFormat format>
Sent bring_up_to_date(PlayerFixture& fixture, PanelMemory<format>& memory, int rows,
                      Size granularity = {pixels_in_whole_bytes(format), 1}, int area_bytes = 11)
{
    const Size panel = fixture.player.panel();
    Bytes pixels(row_bytes(format, panel.width) * static_cast<std::size_t>(rows));
    Sent sent;
    for (;;) {
        const auto changes = fixture.player.draw_changes<format>(pixels, granularity, area_bytes);
        if (changes.empty())
            return sent;
        for (const Change& change : changes) {
            CHECK(change.area.x % granularity.width == 0);
            CHECK(change.area.y % granularity.height == 0);
            REQUIRE(change.pixels.data() + change.pixels.size() <= pixels.data() + pixels.size());
            memory.take(change);
            ++sent.areas;
            sent.bytes += change.pixels.size();
        }
    }
}

}
