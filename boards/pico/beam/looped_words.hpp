#pragma once

#include "boards/pico/chip/dma_channel.hpp"

#include <cstdint>
#include <span>

/// Words from memory to a register at the pace of its unit, over and over, without the processor: neither
/// what it computes nor flash that is being erased delays them. Takes channels 0, 1 and 2 of the DMA.
namespace kfast::pico::looped_words {

/// As the registers of a channel have them.
class Loop {
public:
    Loop() = default;
    explicit Loop(std::span<const std::uint32_t> words)
        : count_{static_cast<std::uint32_t>(words.size())},
          address_{static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(words.data()))}
    {
    }

private:
    std::uint32_t count_ = 0;
    std::uint32_t address_ = 0;
};

/// Starts with `first`, of one word at least, as all of them. Needs start_clocks().
void begin(const Loop& first, Register target, dma::Dreq request);

/// `loop` follows when the one that runs has come to its end. It and its words stay as they are until another
/// one runs. Not one that is right in front of the one that runs (has_gone_over()).
void go_over_to(const Loop& loop);

/// Whether the one that was last gone over to runs, and no other is read any more.
bool has_gone_over();

}
