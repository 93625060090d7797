#include "firmware/link/scene_memory.hpp"

#include <algorithm>
#include <utility>

namespace kfast::link {
namespace {

constexpr std::size_t whole_words(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

}

std::size_t SceneMemory::offset_of(std::span<const std::byte> bytes) const
{
    const auto address = [](const std::byte* at) { return reinterpret_cast<std::uintptr_t>(at); };
    const std::size_t offset = address(bytes.data()) - address(block_.data());
    return bytes.empty() ? block_.size() : std::min<std::size_t>(offset, block_.size());
}

std::span<std::byte> SceneMemory::lease(std::size_t size, std::size_t used, std::span<const std::byte> played)
{
    const auto place = place_for(whole_words(size), whole_words(used), played);
    leased_ = place ? block_.subspan(*place, size) : std::span<std::byte>{};
    return leased_;
}

std::span<std::byte> SceneMemory::before(std::span<const std::byte> played) const
{
    return block_.first(std::min(offset_of(played), offset_of(leased_)));
}

std::optional<std::size_t> SceneMemory::place_for(std::size_t bytes, std::size_t used,
                                                  std::span<const std::byte> played) const
{
    const std::size_t end = block_.size() / 4 * 4;
    const std::size_t scene_begin = std::min(end, offset_of(played));
    const std::size_t scene_end = std::min(end, scene_begin + whole_words(played.size()));
    for (const auto& [from, to] : {std::pair{std::max(used, scene_end), end}, std::pair{used, scene_begin}})
        if (from + bytes <= to)
            return to - bytes;
    return std::nullopt;
}

}
