#include "core/player.hpp"

#include "core/math/fixed.hpp"
#include "core/tracer.hpp"

#include <algorithm>

namespace kfast {
namespace {

/// Scales `bytes` for lengths on the canvas to those on a panel: as many times more as it is larger.
std::size_t scaled_to_panel(std::size_t bytes, Size canvas, Size panel)
{
    const auto scaled = [bytes](int to, int from) {
        const auto larger = static_cast<std::uint32_t>(std::max(to, from));
        return static_cast<std::size_t>(
            quotient(std::uint64_t{bytes} * larger, static_cast<std::uint32_t>(from)));
    };
    return std::max(scaled(panel.width, canvas.width), scaled(panel.height, canvas.height)) / 4 * 4 + 4;
}

/// No more than 24 borders in every band of four rows: few pictures have more everywhere.
std::size_t record_bytes(const SceneView& scene, Size panel)
{
    return std::min(scaled_to_panel(scene.borders() * sizeof(raster::Record::Border), scene.canvas(), panel),
                    static_cast<std::size_t>(panel.height) * 36);
}

/// 0 if nothing is kept from picture to picture.
std::size_t cache_bytes(const SceneView& scene, Size panel)
{
    return scene.cache_bytes() == 0 ? 0 : scaled_to_panel(scene.cache_bytes(), scene.canvas(), panel);
}

raster::RendererNeeds needs_of(const SceneView& scene, Size panel)
{
    return {.outline_bytes = scaled_to_panel(scene.outline_bytes(), scene.canvas(), panel),
            .record_bytes = record_bytes(scene, panel),
            .cache_bytes = cache_bytes(scene, panel),
            .steps = scene.paint_steps(),
            .group_depth = scene.blended_depth()};
}

}

std::size_t Player::block_bytes(const SceneView& scene, Size panel)
{
    return raster::Renderer::block_bytes(needs_of(scene, panel), panel) + bytes_for(scene);
}

Result<Player> Player::create(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> block)
{
    const std::size_t bytes = block_bytes(scene, panel);
    if (block.size() < bytes)
        return Error::block_too_small;
    return Result<Player>{std::in_place, scene, panel, fit, block.first(bytes)};
}

/// What moves is at the end, as it can have any number of bytes.
Player::Player(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> block)
    : SceneState{scene, panel, fit, block.last(bytes_for(scene))},
      panel_{panel},
      renderer_{needs_of(scene, panel), panel, scene.colour(0), block.first(block.size() - bytes_for(scene))}
{
    move_to({});
    trace();
}

void Player::show(Time time) { show_moment(wrap(time, scene().length(), scene().loop())); }

void Player::show_moment(Time moment)
{
    moment = std::clamp(moment, Time{}, scene().length());
    next_row_ = 0;
    if (picture().dependence.is_touched_by(move_to(moment)))
        trace();
}

/// Traces the scene at the time to which it was moved.
void Player::trace()
{
    pose_bones();
    Tracer{on_panel(), renderer_.picture()}.run();
    renderer_.begin();
}

void Player::redraw() { renderer_.forget(); }

template <PixelFormat format>
void Player::draw_rows(int rows, std::span<std::byte> pixels)
{
    renderer_.draw_rows<format>(next_row_, rows, pixels);
    next_row_ += rows;
}

template <PixelFormat format>
std::span<const Change> Player::draw_changes(std::span<std::byte> pixels, Size granularity, int area_bytes)
{
    return renderer_.draw_changes<format>(pixels, granularity, area_bytes);
}

#define KFAST_INSTANTIATE(name, bits)                                                                        \
    template void Player::draw_rows<PixelFormat::name>(int, std::span<std::byte>);                           \
    template std::span<const Change> Player::draw_changes<PixelFormat::name>(std::span<std::byte>, Size, int);
KFAST_PIXEL_FORMATS(KFAST_INSTANTIATE)
#undef KFAST_INSTANTIATE

}
