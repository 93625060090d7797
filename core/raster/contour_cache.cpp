#include "core/raster/contour_cache.hpp"

#include <algorithm>
#include <new>

namespace kfast::raster {

void ContourCache::begin_picture()
{
    if (was_full_)
        remove_unused();
    was_full_ = false;
    ++picture_;
}

/// In the picture that was begun last.
void ContourCache::remove_unused()
{
    std::size_t kept = 0;
    for (std::size_t place = 0; place != used_;) {
        const Set& set = set_at(place);
        const std::size_t bytes = set.bytes;
        if (set.picture == picture_) {
            std::copy(memory_ + place, memory_ + place + bytes, memory_ + kept);
            kept += bytes;
        }
        place += bytes;
    }
    used_ = kept;
}

ContourCache::Set* ContourCache::find(const ContourName& name) const
{
    for (std::size_t place = 0; place != used_; place += set_at(place).bytes)
        if (set_at(place).name == name)
            return &set_at(place);
    return nullptr;
}

std::size_t ContourCache::bytes_in_use() const
{
    std::size_t bytes = 0;
    for (std::size_t place = 0; place != used_; place += set_at(place).bytes)
        bytes += set_at(place).picture == picture_ ? set_at(place).bytes : 0U;
    return bytes;
}

bool ContourCache::find_room(std::size_t bytes)
{
    if (end_ - used_ >= bytes)
        return true;
    was_full_ = true;
    return false;
}

void ContourCache::begin(const ContourName& name)
{
    coming_ = used_;
    is_coming_ = find_room(sizeof(Set));
    if (!is_coming_)
        return;
    new (memory_ + used_) Set{name, 0, picture_};
    used_ += sizeof(Set);
}

void ContourCache::add(std::span<const Corner> contour, std::size_t room)
{
    const std::size_t bytes = sizeof(Counts) + contour.size() * sizeof(ShortCorner);
    if (!is_coming_)
        return;
    if (room > 0xFFFF || !std::ranges::all_of(contour, is_short) || !find_room(bytes)) {
        is_coming_ = false;
        used_ = coming_;
        return;
    }
    new (memory_ + used_)
        Counts{static_cast<std::uint16_t>(contour.size()), static_cast<std::uint16_t>(room)};
    auto* out = reinterpret_cast<ShortCorner*>(memory_ + used_ + sizeof(Counts));
    for (const Corner& corner : contour)
        new (out++) ShortCorner{static_cast<std::int16_t>(corner.x), static_cast<std::int16_t>(corner.y)};
    used_ += bytes;
}

/// A set that is larger than its bytes can tell is not kept either.
void ContourCache::end(bool are_complete)
{
    constexpr std::size_t max_bytes = (1U << 24) - 1;
    if (!is_coming_)
        return;
    is_coming_ = false;
    if (are_complete && used_ - coming_ <= max_bytes)
        set_at(coming_).bytes = static_cast<std::uint32_t>(used_ - coming_) & max_bytes;
    else
        used_ = coming_;
}

}
