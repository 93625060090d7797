#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

namespace kfast::test {

/// Flash as it is: erased by sectors to ones, of which programming makes zeros and nothing else.
class NorFlash {
public:
    static constexpr std::uint32_t begin = 0x1000'0000;
    static constexpr std::size_t sector_bytes = 4096;
    static constexpr std::size_t page_bytes = 256;

    explicit NorFlash(std::size_t sectors) : bytes_(sectors * sector_bytes, std::byte{0xFF}) {}

    void erase_sector(std::uint32_t address)
    {
        std::ranges::fill(place(address, sector_bytes, sector_bytes), std::byte{0xFF});
    }

    void program_page(std::uint32_t address, std::span<const std::byte> page)
    {
        const auto there = place(address, page_bytes, page_bytes);
        std::ranges::transform(there, page.first(page_bytes), there.begin(), std::bit_and<>{});
    }

    std::span<const std::byte> read(std::uint32_t address, std::size_t count)
    {
        return place(address, count, page_bytes);
    }

    std::vector<std::byte>& bytes() { return bytes_; }
    const std::vector<std::byte>& bytes() const { return bytes_; }

private:
    std::span<std::byte> place(std::uint32_t address, std::size_t count, std::size_t unit)
    {
        if (address < begin || address % unit != 0 || address - begin + count > bytes_.size())
            throw std::logic_error{"no such place in flash"};
        return std::span{bytes_}.subspan(address - begin, count);
    }

    std::vector<std::byte> bytes_;
};

}
