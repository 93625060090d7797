#include "core/scene/scene_view.hpp"

#include "core/bytes/byte_reader.hpp"
#include "core/scene/track_view.hpp"

namespace kfast {

Clock ClockCursor::next()
{
    --left_;
    Clock clock;
    clock.driver = {static_cast<std::uint8_t>(bytes_.u8())};
    clock.loop = static_cast<Loop>(bytes_.u8());
    clock.delay = {bytes_.signed_varint()};
    clock.speed = bytes_.signed_varint();
    clock.length = read_time_code(bytes_);
    return clock;
}

ClipView ClipCursor::next()
{
    --left_;
    ClipView clip;
    clip.name = read_name(bytes_);
    clip.begin = read_time_code(bytes_);
    clip.end = clip.begin + read_time_code(bytes_);
    clip.loop = static_cast<Loop>(bytes_.u8());
    return clip;
}

EventView EventCursor::next()
{
    time_ = time_ + read_time_code(bytes_);
    const std::string_view name = read_name(bytes_);
    return {name, time_};
}

Colour SceneView::colour(std::size_t index) const
{
    const std::byte* at = palette_.data() + colour_bytes_ * index;
    const auto channel = [at](int number) { return std::to_integer<std::uint8_t>(at[number]); };
    return {channel(0), channel(1), channel(2), colour_bytes_ == 4 ? channel(3) : std::uint8_t{255}};
}

SkinReader SceneView::skin(std::int32_t skin) const
{
    if (skin < 0)
        return SkinReader::of(bone_of(skin));
    return SkinReader{ByteReader{drawings_.subspan(static_cast<std::size_t>(skin))}};
}

LawPair SceneView::laws(std::uint32_t number) const { return laws_at(place_of_laws(number)); }

/// 0 for the pair 0, which is not stored, else the distance from the byte before the first one.
std::uint16_t SceneView::place_of_laws(std::uint32_t number) const
{
    if (number == 0)
        return 0;
    ByteReader reader = laws_;
    for (; number > 1; --number)
        read_law_pair(reader);
    return static_cast<std::uint16_t>(laws_.left() - reader.left() + 1);
}

LawPair SceneView::laws_at(std::uint16_t place) const
{
    if (place == 0)
        return {};
    ByteReader reader = laws_;
    reader.skip(place - 1U);
    return read_law_pair(reader);
}

std::size_t SceneView::first_bone(std::uint32_t skeleton) const
{
    std::size_t first = 0;
    for (SkeletonCursor cursor = skeletons(); skeleton > 0; --skeleton)
        first += cursor.skip();
    return first;
}

ItemCursor SceneView::items_in(const ItemView& item) const
{
    return item.kind == ItemKind::group ? ItemCursor{item.items} : symbol(item.symbol);
}

ItemCursor SceneView::symbol(std::uint32_t number) const
{
    ByteReader reader = symbols_;
    for (; number > 0; --number)
        reader.skip(reader.varint());
    return ItemCursor{reader.take(reader.varint())};
}

InputView SceneView::input(std::uint32_t number) const
{
    InputCursor cursor = inputs();
    for (; number > 0; --number)
        cursor.next();
    return cursor.next();
}

std::optional<std::uint32_t> SceneView::input(std::string_view name) const
{
    std::uint32_t number = 0;
    for (InputCursor cursor = inputs(); !cursor.at_end(); ++number)
        if (cursor.next().name == name)
            return number;
    return std::nullopt;
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
