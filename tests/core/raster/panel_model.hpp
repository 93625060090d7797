#pragma once

#include "core/pixel/pixel_format.hpp"
#include "core/raster/renderer.hpp"

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

namespace kfast::raster {

/// What a panel shows that takes the areas of a renderer.
template <PixelFormat format>
class PanelModel {
public:
    PanelModel(Size size, Size granularity)
        : size_{size}, granularity_{granularity}, pixels_(stride() * static_cast<std::size_t>(size.height))
    {
    }

    /// Until all is drawn. `rows` whole rows fit into the memory for areas.
    void take(Renderer& renderer, int rows)
    {
        std::vector<std::uint32_t> memory(stride() * static_cast<std::size_t>(rows) / 4 + 1);
        const auto pixels =
            std::as_writable_bytes(std::span{memory}).first(stride() * static_cast<std::size_t>(rows));
        for (;;) {
            const auto changes = renderer.draw_changes<format>(pixels, granularity_, 11);
            if (changes.empty())
                return;
            for (const Change& change : changes)
                take(change);
        }
    }

    const std::vector<std::byte>& pixels() const { return pixels_; }
    std::size_t sent_bytes() const { return sent_bytes_; }
    /// No area lay where the panel does not take it.
    bool is_valid() const { return is_sound_; }

private:
    std::size_t stride() const { return row_bytes(format, size_.width); }

    void take(const Change& change)
    {
        const Rect& area = change.area;
        const std::size_t bytes = row_bytes(format, area.width);
        const auto ends_well = [](int end, int unit, int size) {
            return end == size || (end < size && end % unit == 0);
        };
        is_sound_ = is_sound_ && area.x >= 0 && area.y >= 0 && area.x % granularity_.width == 0 &&
                    area.y % granularity_.height == 0 &&
                    ends_well(area.x + area.width, granularity_.width, size_.width) &&
                    ends_well(area.y + area.height, granularity_.height, size_.height) &&
                    change.pixels.size() == bytes * static_cast<std::size_t>(area.height);
        if (!is_sound_)
            return;
        for (int row = 0; row < area.height; ++row)
            std::memcpy(pixels_.data() + static_cast<std::size_t>(area.y + row) * stride() +
                            row_bytes(format, area.x),
                        change.pixels.data() + static_cast<std::size_t>(row) * bytes, bytes);
        sent_bytes_ += change.pixels.size();
    }

    Size size_;
    Size granularity_;
    std::vector<std::byte> pixels_;
    std::size_t sent_bytes_ = 0;
    bool is_sound_ = true;
};

}
