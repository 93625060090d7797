#include "core/bytes/crc32.hpp"
#include "core/prepared/preparer.hpp"
#include "core/scene/check/scene_check.hpp"
#include "core/scene/format.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/scene_view.hpp"
#include "core/scene/track_view.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace kfast {
namespace {

/// Beyond the format's limit it stays beyond it.
std::uint32_t read_words(ByteReader& bytes, std::uint32_t max_bytes)
{
    constexpr std::uint32_t unit = kfb::header::memory_unit;
    return unit * std::min(bytes.varint(), max_bytes / unit + 1);
}

int read_side(ByteReader& bytes)
{
    return static_cast<int>(std::min<std::uint32_t>(bytes.varint(), kfb::max_canvas + 1));
}

ByteReader take_block(ByteReader& bytes) { return bytes.take(bytes.varint()); }

}

// Once a scene: a board that runs from RAM can leave it in flash.
[[gnu::cold]] Result<SceneView> SceneView::parse(std::span<const std::byte> bytes, const Features& features,
                                                 std::uint32_t* item)
{
    Result<SceneView> scene{std::in_place, Unread{}}; // constructed in place, for a small stack
    scene->features_ = features;
    if (const auto error = scene->read(bytes, item))
        scene.fail(*error);
    return scene;
}

/// Returns why the scene cannot be played.
[[gnu::cold]] std::optional<Error> SceneView::read(std::span<const std::byte> bytes, std::uint32_t* item)
{
    ByteReader reader{bytes};
    const std::uint32_t tag = reader.u32();
    const std::uint32_t checksum = reader.u32();
    const std::size_t body = reader.varint();
    if (bytes.size() >= 3 && kfb::tag::magic.get(tag) != kfb::tag::magic_value)
        return Error::bad_magic;
    if (bytes.size() >= 4 && kfb::tag::version.get(tag) != kfb::version)
        return Error::unsupported_version;
    if (reader.overrun() || reader.left() < body)
        return Error::truncated;
    size_ = bytes.size() - reader.left() + body;
    Crc32 crc;
    crc.add(bytes.first(size_).subspan(kfb::header::checksum_end));
    if (crc.value() != checksum)
        return Error::bad_checksum;
    if (!read_sections(reader.take(body)))
        return Error::bad_scene;
    if (const auto error = check(item))
        return error;
    if (!count_records())
        return Error::bad_scene;
    return cost_ == PictureCost::max ? std::optional{Error::too_slow} : std::nullopt;
}

/// Few scenes have many symbols: only these take 3 KB more of the stack.
[[gnu::cold]] std::optional<Error> SceneView::check(std::uint32_t* item)
{
    constexpr std::size_t few = 12;
    return symbol_count_ <= few ? check_in_room<few>(item) : check_in_room<kfb::max_symbols>(item);
}

template <std::size_t symbols>
[[gnu::cold, gnu::noinline]] std::optional<Error> SceneView::check_in_room(std::uint32_t* item)
{
    std::array<ItemTotals, symbols> room{};
    return check(item, std::span{room}.first(symbol_count_));
}

[[gnu::cold, gnu::noinline]] std::optional<Error> SceneView::check(std::uint32_t* item,
                                                                   std::span<ItemTotals> symbols)
{
    SceneCheck check{*this, symbols};
    const bool passes = check.passes();
    if (item != nullptr)
        *item = check.item();
    return passes ? std::nullopt : std::optional{check.error()};
}

/// Counts what a scene needs when it is laid out. Returns whether that is no more than the format allows.
[[gnu::cold, gnu::noinline]] bool SceneView::count_records()
{
    Preparer preparer{*this, {}};
    preparer.run();
    const SceneRecords nested = records_;
    records_ = preparer.records();
    records_.spaces = nested.spaces;
    records_.levels = nested.levels;
    const std::uint32_t cost = cost_ + cost_of_records(records_, preparer.keys(), borders_);
    cost_ = static_cast<std::uint16_t>(std::min(cost, PictureCost::max));
    return records_.timelines < TrackState::no_timeline && records_.tracks <= kfb::max_tracks &&
           records_.nodes <= kfb::max_nodes;
}

/// The number of clips, which is behind the clocks, may be left out with all that follows.
[[gnu::cold]] void SceneView::read_marks(ByteReader marks)
{
    clock_count_ = marks.left() == 0 ? 0 : marks.u8();
    clocks_ = marks;
    ClockCursor clocks = this->clocks();
    while (!clocks.at_end())
        clocks.next();
    marks_ = clocks.rest();
}

[[gnu::cold]] bool SceneView::read_sections(ByteReader reader)
{
    outline_bytes_ = read_words(reader, kfb::max_outline_bytes);
    borders_ = std::min(reader.varint(), kfb::max_borders + 1);
    cache_bytes_ = read_words(reader, kfb::max_cache_bytes);
    const std::uint32_t head = reader.u8();
    loop_ = static_cast<Loop>(kfb::header::loop.get(head));
    length_ = read_time_code(reader);
    frame_rate_ = rate_of(reader.varint());
    canvas_.width = read_side(reader);
    canvas_.height = read_side(reader);
    camera_ = kfb::header::has_camera.get(head) ? static_cast<std::int32_t>(reader.varint())
                                                : default_camera(canvas_);
    const std::size_t colours = reader.u8();
    colour_bytes_ = kfb::header::has_opacity.get(head) ? 4 : 3;
    palette_ = reader.take(colours * colour_bytes_).rest();
    law_count_ = reader.u8();
    laws_ = reader;
    for (std::uint32_t pair = 0; pair < law_count_; ++pair)
        read_law_pair(reader);
    if (kfb::header::has_inputs.get(head)) {
        input_count_ = reader.u8();
        inputs_ = take_block(reader);
        if (input_count_ == 0)
            return false; // then the header says that there are none
    }
    if (kfb::header::has_marks.get(head))
        read_marks(take_block(reader));
    if (kfb::header::has_bones.get(head))
        bones_ = take_block(reader);
    if (kfb::header::has_symbols.get(head)) {
        symbol_count_ = reader.u8();
        symbols_ = take_block(reader);
    }
    items_ = take_block(reader);
    drawings_ = reader.rest();
    return !reader.overrun();
}

}
