#include "core/scene_view.hpp"

#include "core/crc32.hpp"
#include "core/kfb_limits.hpp"
#include "core/scene_check.hpp"

namespace kfast {
namespace {

constexpr std::uint32_t magic = 'K' | 'F' << 8 | 'B' << 16;
constexpr std::size_t checksum_end = 8; ///< the checksum covers everything behind itself

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
    if (!scene.read_sections(bytes.first(size)) || !SceneCheck{scene}.passes())
        return Error::bad_scene;
    return scene;
}

bool SceneView::read_sections(std::span<const std::byte> bytes)
{
    ByteReader reader{bytes.subspan(checksum_end + 4)};
    outline_bytes_ = reader.u32();
    law_count_ = reader.u8();
    loop_ = static_cast<Loop>(reader.u8());
    length_.ticks = static_cast<std::int32_t>(reader.u32());
    frame_rate_ = reader.u32();
    canvas_.width = static_cast<int>(reader.u16());
    canvas_.height = static_cast<int>(reader.u16());
    const std::size_t colours = reader.u8();
    symbol_count_ = reader.u8();
    camera_ = static_cast<std::int32_t>(reader.u16());
    palette_ = reader.take(colours * colour_bytes).rest();
    laws_ = reader;
    for (std::uint32_t pair = 0; pair < law_count_; ++pair)
        read_law_pair(reader);
    marks_ = reader.take(reader.varint());
    bones_ = reader.take(reader.varint());
    symbols_ = reader.take(reader.varint());
    items_ = reader.take(reader.varint());
    drawings_ = reader.rest();
    return !reader.overrun();
}

Colour SceneView::colour(std::size_t index) const
{
    const auto channel = [this, index](std::size_t number) {
        return std::to_integer<std::uint8_t>(palette_[colour_bytes * index + number]);
    };
    return {channel(0), channel(1), channel(2), channel(3)};
}

LawPair SceneView::laws(std::uint32_t number) const
{
    LawPair laws;
    for (ByteReader reader = laws_; number > 0; --number)
        laws = read_law_pair(reader);
    return laws;
}

std::size_t SceneView::first_bone(std::uint32_t skeleton) const
{
    std::size_t first = 0;
    for (BonesCursor cursor = skeletons(); skeleton > 0; --skeleton)
        first += cursor.skip();
    return first;
}

ItemCursor SceneView::symbol(std::uint32_t number) const
{
    ByteReader reader = symbols_;
    for (; number > 0; --number)
        reader.skip(reader.varint());
    return ItemCursor{reader.take(reader.varint())};
}

ClipCursor SceneView::clips() const
{
    ByteReader reader = marks_;
    const std::uint32_t count = reader.u8();
    return {reader, count};
}

std::optional<ClipView> SceneView::clip(std::string_view name) const
{
    for (ClipCursor cursor = clips(); !cursor.at_end();) {
        const ClipView clip = cursor.next();
        if (clip.name == name)
            return clip;
    }
    return std::nullopt;
}

EventCursor SceneView::events() const
{
    ClipCursor cursor = clips();
    while (!cursor.at_end())
        cursor.next();
    return EventCursor{ByteReader{cursor.rest().rest()}};
}

}
