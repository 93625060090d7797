#pragma once

#include "host/picture/frame_source.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace kfast {

/// The pictures of several moments, drawn one by one and kept.
class FrameCollection {
public:
    /// All of one collection together; more is not wanted in the memory of a computer that has other things
    /// to do.
    static constexpr std::size_t max_bytes = std::size_t{1} << 30;

    explicit FrameCollection(std::vector<Time> moments);

    std::size_t total() const { return moments_.size(); }
    std::size_t done() const { return frames_.size(); }
    bool is_complete() const { return done() == total(); }
    /// Draws the next one; there must be one left.
    void add_next(FrameSource& source);
    struct Drawn {
        Frame frame;
        std::string facts; ///< FrameSource::facts()
    };
    /// Null where that moment was not drawn.
    const Drawn* at(Time moment) const;

private:
    std::vector<Time> moments_;
    std::vector<Drawn> frames_; ///< of the first moments
};

}
