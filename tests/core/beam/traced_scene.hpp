#pragma once

#include "core/beam/beam_tracer.hpp"
#include "core/pose/scene_state.hpp"
#include "tests/core/player_fixture.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace kfast::test {

struct TracedBytes {
    Bytes file;
    Bytes block;

    explicit TracedBytes(Bytes scene) : file{std::move(scene)} {}
};

/// The lit lines of a scene at any moment.
class TracedScene : private TracedBytes, public SceneState {
public:
    static constexpr int resolution = 256;

    explicit TracedScene(Bytes scene)
        : TracedBytes{std::move(scene)},
          SceneState{accepted(file), {resolution, resolution}, Fit::contain, memory()},
          storage_(1 << 18)
    {
    }

    const BeamLines& lines(Time time)
    {
        lines_ = BeamLines{std::as_writable_bytes(std::span{storage_})};
        pose(time);
        BeamTracer{on_panel(), resolution, lines_}.run();
        return lines_;
    }

private:
    std::span<std::byte> memory()
    {
        block.resize(bytes_for(accepted(file)));
        return block;
    }

    std::vector<std::uint32_t> storage_;
    BeamLines lines_;
};

}
