#pragma once

#include "core/scene/scene_view.hpp"
#include "firmware/status.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>

namespace kfast::link {

// Compound requirements would be torn apart.
// clang-format off

/// Where the bytes of a scene go that comes over the link.
template <class S>
concept Sink = requires(S& sink, std::span<const std::byte> bytes) {
    /// The next bytes: no more, altogether, than the size that was announced when it began.
    { sink.write(bytes) } -> std::same_as<void>;
    /// All bytes have come, and their checksum is correct. Fails if they are no scene, or were not kept; then
    /// everything is as before.
    { sink.finish() } -> std::same_as<Status>;
};

// clang-format on

/// Memory that a scene is written into.
class RamSink {
public:
    RamSink() = default;
    /// `place` is as long as the scene.
    explicit RamSink(std::span<std::byte> place) : place_{place} {}

    void write(std::span<const std::byte> bytes)
    {
        std::ranges::copy(bytes, place_.subspan(filled_).begin());
        filled_ += bytes.size();
    }
    /// Fails with an error of SceneView::parse.
    Status finish() const
    {
        const auto scene = SceneView::parse(place_, every_feature_but_outlines);
        return scene ? Status::ok : status_of(scene.error());
    }

    std::span<const std::byte> bytes() const { return place_; }

private:
    std::span<std::byte> place_;
    std::size_t filled_ = 0;
};

}
