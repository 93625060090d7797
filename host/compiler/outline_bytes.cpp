#include "host/compiler/outline_bytes.hpp"

#include "core/kfb_limits.hpp"
#include "core/player.hpp"
#include "host/compiler/header.hpp"

#include <algorithm>

namespace kfast {
namespace {

constexpr std::int32_t most_moments = 4000;
constexpr std::int32_t moments_of_frame = 4;
constexpr std::uint32_t least_bytes = 64;

std::size_t most_used_bytes(Player& player)
{
    const std::int32_t length = player.scene().length().ticks;
    const std::int32_t step = std::max(Time::ticks_per_frame / moments_of_frame, length / most_moments);
    std::size_t most = 0;
    for (std::int32_t moment = 0; moment < length + step; moment += step) {
        player.show_moment({std::min(moment, length)});
        most = std::max(most, player.picture().outlines.used_bytes());
    }
    return most;
}

}

std::uint32_t outline_bytes(std::vector<std::byte> file)
{
    set_outline_bytes(file, kfb::max_outline_bytes);
    const auto scene = SceneView::parse(file);
    std::vector<std::uint32_t> block((Player::block_bytes(*scene, scene->canvas()) + 3) / 4);
    auto player = Player::create(*scene, scene->canvas(), Fit::contain, std::as_writable_bytes(std::span{block}));
    const std::size_t most = most_used_bytes(*player);
    const std::size_t wanted = (most + most / 8 + least_bytes) / 4 * 4;
    return static_cast<std::uint32_t>(std::min<std::size_t>(wanted, kfb::max_outline_bytes));
}

}
