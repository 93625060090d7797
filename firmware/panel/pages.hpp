#pragma once

#include <cstddef>
#include <span>

namespace kfast {

/// Converts rows of mono1 to pages, as controllers of small OLEDs take them: a byte is eight pixels below
/// each other, the uppermost in the lowest bit; a page is eight rows, from left to right. Both `rows` and
/// `pages` hold whole pages of `row_bytes` times 8 columns.
constexpr void fill_pages(std::span<const std::byte> rows, std::size_t row_bytes, std::span<std::byte> pages)
{
    const auto turn_block = [row_bytes](const std::byte* row, std::byte* columns) {
        for (int y = 0; y < 8; ++y, row += row_bytes) {
            for (int x = 0; x < 8; ++x)
                columns[x] = columns[x] >> 1 | (*row << x & std::byte{0x80});
        }
    };
    const std::size_t bytes_of_page = 8 * row_bytes;
    for (std::size_t page = 0; page < rows.size(); page += bytes_of_page) {
        for (std::size_t block = 0; block < row_bytes; ++block)
            turn_block(&rows[page + block], &pages[page + 8 * block]);
    }
}

}
