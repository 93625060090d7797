#include "host/picture/frame_source.hpp"

#include "core/player.hpp"
#include "host/picture/picture.hpp"
#include "host/picture/timeline.hpp"
#include "host/player/word_block.hpp"

#include <algorithm>

namespace kfast {

bool give_input(SceneState& scene, std::uint32_t number, const InputContent& content)
{
    if (const auto* const strokes = std::get_if<std::span<const InputStroke>>(&content))
        return scene.set_drawing(number, *strokes);
    if (const auto* const text = std::get_if<std::string_view>(&content))
        scene.set_text(number, *text);
    else
        scene.set_input(number, std::get<Time>(content));
    return true;
}

Detail detail_of(const raster::Picture& picture)
{
    if (picture.outlines.is_full())
        return Detail::parts_missing;
    return picture.is_coarse() ? Detail::coarse : Detail::full;
}

CoarsePictures coarse_pictures(const SceneView& scene, Size panel, std::size_t max_pictures)
{
    const Timeline timeline = timeline_of(scene);
    const int frames = timeline.frame_count();
    const int count = static_cast<int>(std::min(static_cast<std::size_t>(frames), max_pictures));
    WordBlock block{Player::block_bytes(scene, panel)};
    auto player = Player::create(scene, panel, Fit::contain, block.bytes());
    CoarsePictures pictures{.looked_at = static_cast<std::size_t>(count)};
    for (int i = 0; i < count; ++i) {
        player->show_moment(timeline.frame_time(static_cast<int>(std::int64_t{frames} * i / count)));
        pictures.coarse += player->is_coarse() ? 1 : 0;
    }
    return pictures;
}

void ShownDetail::add(const raster::Picture& picture)
{
    last_ = detail_of(picture);
    min_ = std::min(min_, last_);
}

std::string ShownDetail::text() const
{
    switch (last_) {
    case Detail::parts_missing:
        return "parts are missing, for want of room";
    case Detail::coarse:
        return "curves are coarser, for want of room";
    case Detail::full:
        break;
    }
    return {};
}

const Frame& ScaledSource::show(Time moment)
{
    const Picture picture = scaled(widen(source_->show(moment)), factor_);
    frame_ = {std::nullopt, picture.size, channel_bytes(picture)};
    return frame_;
}

}
