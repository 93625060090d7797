#pragma once

#include "firmware/slots/flash.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Erases the sector at `offset` and programs `bytes`, at most sector_bytes, from its beginning on; they may
/// lie in another sector. Returns whether the sector holds them.
template <Flash F>
bool write_sector(F& flash, std::uint32_t offset, std::span<const std::byte> bytes)
{
    flash.erase(offset);
    for (std::uint32_t at = 0; at < bytes.size(); at += page_bytes) {
        std::array<std::byte, page_bytes> page;
        page.fill(std::byte{0xFF}); // what is not programmed stays erased
        std::ranges::copy(bytes.subspan(at, std::min<std::size_t>(page_bytes, bytes.size() - at)),
                          page.begin());
        flash.program(offset + at, page);
    }
    return std::ranges::equal(bytes, flash.contents().subspan(offset, bytes.size()));
}

}
