#include "host/compiler/drawing_pool.hpp"

#include "host/compiler/pack_drawing.hpp"

#include <utility>

namespace kfast {

std::uint32_t DrawingPool::offset_of(const scene::Drawing& drawing)
{
    ByteWriter packed;
    pack_drawing(drawing, packed);
    std::string key{reinterpret_cast<const char*>(packed.bytes().data()), packed.size()};
    const auto [entry, is_new] =
        offsets_.emplace(std::move(key), static_cast<std::uint32_t>(section_.size()));
    if (is_new)
        section_.append(packed.bytes());
    return entry->second;
}

}
