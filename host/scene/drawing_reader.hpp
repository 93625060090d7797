#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/model.hpp"
#include "host/scene/outline.hpp"
#include "host/scene/reading.hpp"

#include <cstddef>
#include <utility>

namespace kfast::scene {

/// Collects the strokes of one drawing.
class DrawingReader {
public:
    explicit DrawingReader(Reading& reading) : reading_{reading} {}

    /// Adds the strokes of `node`, for which is_shape() holds; reports it when it is wrong.
    void read(const kdl::Node& node);
    Drawing take() { return std::move(drawing_); }

private:
    bool add(const Outline& outline, const kdl::Node& node);

    Reading& reading_;
    Drawing drawing_;
    std::size_t points_ = 0;
};

}
