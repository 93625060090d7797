#pragma once

#include "core/raster/outline/picture.hpp"

#include <cstddef>
#include <cstdint>
#include <map>

namespace kfast {

/// The bytes that the outlines of each item take, by their paths (core/scene/item_view.hpp).
inline std::map<std::uint32_t, std::size_t> outline_bytes_by_item(const raster::Picture& picture)
{
    std::map<std::uint32_t, std::size_t> bytes;
    picture.outlines.each_chain([&](const raster::Chain& chain) {
        bytes[picture.steps()[chain.layer].item] += raster::OutlineStore::chain_bytes(chain);
    });
    return bytes;
}

}
