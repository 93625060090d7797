#include "host/compiler/drawing_pool.hpp"

#include "host/compiler/pack_drawing.hpp"

#include <utility>

namespace kfast {

std::uint32_t DrawingPool::offset_of(const scene::Drawing& drawing)
{
    ByteWriter packed;
    pack_drawing(drawing, packed);
    return offset_of(packed.bytes());
}

std::uint32_t DrawingPool::offset_of(std::span<const std::byte> bytes)
{
    std::string key{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    const auto [entry, is_new] =
        offsets_.emplace(std::move(key), static_cast<std::uint32_t>(section_.size()));
    if (is_new)
        section_.append(bytes);
    return entry->second;
}

}
