#include "boards/pico/chip/dma.hpp"

#include "boards/pico/chip/resets.hpp"

#include <atomic>

namespace kfast::pico::dma {
namespace {

constexpr Channel channel{0};

}

void begin() { resets::restart(resets::dma); }

void start(std::span<const std::byte> bytes, Piece piece, Register target, Request request)
{
    std::atomic_signal_fence(std::memory_order_release); // the bytes are in memory before the unit looks
    const auto width = static_cast<std::uint32_t>(piece);
    channel.read_address().write(reinterpret_cast<std::uintptr_t>(bytes.data()));
    channel.write_address().write(target.address());
    channel.transfer_count().write(static_cast<std::uint32_t>(bytes.size()) >> width);
    channel.control_and_start().write(enabled | high_priority | piece_of(piece) | read_next |
                                      chain_to(channel) | paced_by(request) | quiet);
}

bool busy()
{
    const bool result = (channel.control().read() & is_busy) != 0;
    std::atomic_signal_fence(std::memory_order_acquire); // nobody writes to the bytes before
    return result;
}

}
