#pragma once

#include "core/beam/beam_player.hpp"
#include "tests/core/player_fixture.hpp"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::test {

/// A player for a beam and what it borrows.
struct BeamPlayerFixture {
    Bytes bytes;
    SceneView scene;
    Bytes block;
    BeamPlayer player;

    explicit BeamPlayerFixture(std::string_view text, const BeamProfile& profile = scope_profile,
                               std::uint32_t budget = 100'000)
        : BeamPlayerFixture{compiled(text), profile, budget}
    {
    }

    BeamPlayerFixture(Bytes file, const BeamProfile& profile, std::uint32_t budget)
        : bytes{std::move(file)},
          scene{accepted(bytes)},
          block(BeamPlayer::block_bytes(scene, profile)),
          player{*BeamPlayer::create(scene, profile, budget, block)}
    {
    }

    std::vector<BeamPoint> points(Time time)
    {
        player.show(time);
        std::vector<BeamPoint> all;
        std::array<BeamPoint, 7> piece;
        PointStream plot = player.plot();
        while (const std::size_t count = plot.next(piece))
            all.insert(all.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(count));
        return all;
    }
};

}
