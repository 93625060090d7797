#include "core/scene_view.hpp"

#include "core/crc32.hpp"
#include "core/edge_budget.hpp"

namespace kfast {
namespace {

constexpr std::uint32_t magic = 'K' | 'F' << 8 | 'B' << 16;
constexpr std::size_t checksum_end = 8; ///< the checksum covers everything behind itself

bool is_in_range(const Key& key)
{
    const auto is_law = [](VelocityLaw law) { return static_cast<int>(law) < velocity_law_count; };
    return key.time.ticks <= kfb::max_time && is_law(key.law_x) && is_law(key.law_y) &&
           key.curve_pieces >= 1 && key.curve_pieces <= kfb::max_curve_pieces;
}

}

Result<SceneView> SceneView::parse(std::span<const std::byte> bytes)
{
    ByteReader reader{bytes};
    const std::uint32_t tag = reader.u32();
    const std::uint32_t checksum = reader.u32();
    const std::size_t size = reader.u32();
    if (bytes.size() >= 3 && (tag & 0xFFFFFF) != magic)
        return Error::bad_magic;
    if (bytes.size() >= 4 && tag >> 24 != kfb::version)
        return Error::unsupported_version;
    if (bytes.size() < kfb::header_bytes || bytes.size() < size)
        return Error::truncated;
    if (size < kfb::header_bytes)
        return Error::bad_scene;
    Crc32 crc;
    crc.add(bytes.first(size).subspan(checksum_end));
    if (crc.value() != checksum)
        return Error::bad_checksum;
    SceneView scene;
    scene.size_ = size;
    if (!scene.read_sections(bytes.first(size)) || !scene.check_header() || !scene.check_objects())
        return Error::bad_scene;
    return scene;
}

bool SceneView::read_sections(std::span<const std::byte> bytes)
{
    ByteReader reader{bytes.subspan(checksum_end + 4)};
    max_edges_ = reader.u32();
    length_.ticks = static_cast<std::int32_t>(reader.u32());
    frame_rate_ = reader.u32();
    canvas_.width = static_cast<int>(reader.u16());
    canvas_.height = static_cast<int>(reader.u16());
    object_count_ = reader.u16();
    const std::size_t palette_bytes = 3 * reader.u8();
    loop_ = static_cast<Loop>(reader.u8());
    if (palette_bytes > reader.left())
        return false;
    palette_ = reader.rest().first(palette_bytes);
    reader.skip(palette_bytes);
    const std::size_t object_bytes = reader.varint();
    if (reader.overrun() || object_bytes > reader.left())
        return false;
    objects_ = reader.rest().first(object_bytes);
    drawings_ = reader.rest().subspan(object_bytes);
    return true;
}

bool SceneView::check_header() const
{
    const auto is_side = [](int pixels) { return pixels >= 1 && pixels <= kfb::max_canvas; };
    return is_side(canvas_.width) && is_side(canvas_.height) && frame_rate_ >= 1 &&
           frame_rate_ <= kfb::max_frame_rate && length_.ticks >= Time::ticks_per_frame &&
           length_.ticks <= kfb::max_time && loop_ <= Loop::ping_pong && !palette_.empty() &&
           max_edges_ <= kfb::max_edges;
}

bool SceneView::check_objects()
{
    std::uint32_t key_points = 0;
    std::uint32_t edges = 0;
    ObjectCursor cursor = objects();
    while (!cursor.at_end()) {
        const ObjectView object = cursor.next();
        if (cursor.overrun() || !check_style(object.style) || !check_keys(object, key_points))
            return false;
        layers_ += (object.style.is_filled ? 1U : 0U) + (object.style.is_stroked ? 1U : 0U);
        edges += object_edges(object, drawings_);
        if (edges > max_edges_)
            return false;
    }
    return cursor.bytes_left() == 0;
}

bool SceneView::check_style(const ObjectStyle& style) const
{
    if (style.is_filled && style.fill >= palette_size())
        return false;
    if (!style.is_stroked)
        return style.is_filled && style.cap == Cap{} && style.join == Join{};
    return style.stroke < palette_size() && style.width >= 1 && style.width <= kfb::max_width &&
           style.cap <= Cap::square && style.join <= Join::bevel;
}

bool SceneView::check_keys(const ObjectView& object, std::uint32_t& key_points)
{
    KeyCursor keys = object.keys;
    if (keys.at_end())
        return false;
    Time before{-1};
    while (!keys.at_end()) {
        const Key key = keys.next();
        if (keys.overrun() || key.time <= before || !is_in_range(key) || !check_drawing(key, key_points))
            return false;
        before = key.time;
    }
    return true;
}

bool SceneView::check_drawing(const Key& key, std::uint32_t& key_points) const
{
    if (key.drawing >= drawings_.size())
        return false;
    PackedDrawing reader = drawing(key);
    std::uint32_t points = reader.strokes();
    if (points > kfb::max_drawing_points)
        return false;
    for (std::uint32_t stroke = 0; stroke < reader.strokes(); ++stroke) {
        const std::uint32_t segments = reader.next_stroke();
        points += segments;
        if (!reader.is_sound() || segments > kfb::max_drawing_points || points > kfb::max_drawing_points)
            return false;
        for (std::uint32_t i = 0; i < segments; ++i) {
            reader.next_segment();
            if (!reader.is_sound())
                return false;
        }
    }
    key_points += points + 1;
    return reader.is_sound() && key_points <= kfb::max_key_points;
}

Colour SceneView::colour(std::size_t index) const
{
    const auto channel = [this, index](std::size_t number) {
        return std::to_integer<std::uint8_t>(palette_[3 * index + number]);
    };
    return {channel(0), channel(1), channel(2)};
}

}
