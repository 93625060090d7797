#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast {

/// Memory for a player: aligned to 4 bytes, all 0 at first. Stays where it is when the block is moved.
class WordBlock {
public:
    explicit WordBlock(std::size_t bytes)
        : words_((bytes + sizeof(std::uint32_t) - 1) / sizeof(std::uint32_t))
    {
    }

    std::span<std::byte> bytes() { return std::as_writable_bytes(std::span{words_}); }

private:
    std::vector<std::uint32_t> words_;
};

}
