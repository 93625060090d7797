#pragma once

#include "host/picture/frame_source.hpp"

#include <memory>

namespace kfast {

/// What another source shows, in larger pixels and without its pixel format.
class ScaledSource : public FrameSource {
public:
    /// `factor` is at least 1. show() throws Failure where a picture would become too large.
    ScaledSource(std::unique_ptr<FrameSource> source, int factor)
        : source_{std::move(source)}, factor_{factor}
    {
    }

    const Frame& show(Time moment) override;
    void set_input(std::uint32_t number, Time place) override { source_->set_input(number, place); }
    bool set_drawing(std::uint32_t number, std::span<const InputStroke> strokes) override
    {
        return source_->set_drawing(number, strokes);
    }
    void set_text(std::uint32_t number, std::string_view text) override { source_->set_text(number, text); }
    Pace pace() const override { return source_->pace(); }
    std::string facts() const override { return source_->facts(); }
    Detail min_detail() const override { return source_->min_detail(); }
    void reveal(bool hidden) override { source_->reveal(hidden); }

private:
    std::unique_ptr<FrameSource> source_;
    int factor_;
    Frame frame_;
};

}
