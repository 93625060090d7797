#pragma once

#include "host/picture/frame_source.hpp"

#include <functional>

namespace kfast::test {

/// Pictures in rgb565 that a function of frame and position paints.
class PaintedSource : public FrameSource {
public:
    using Paint = std::function<int(int frame, int x, int y)>;

    PaintedSource(Size size, Paint paint) : paint_{std::move(paint)}, frame_{PixelFormat::rgb565, size, {}} {}

    bool set(std::uint32_t, const InputContent&) override { return true; }
    const Frame& show(Time time) override
    {
        frame_.pixels.clear();
        for (int y = 0; y < frame_.size.height; ++y)
            for (int x = 0; x < frame_.size.width; ++x) {
                const int word = paint_(time.ticks / Time::ticks_per_frame, x, y);
                frame_.pixels.push_back(static_cast<std::byte>(word & 255));
                frame_.pixels.push_back(static_cast<std::byte>(word >> 8));
            }
        return frame_;
    }

private:
    Paint paint_;
    Frame frame_;
};

}
