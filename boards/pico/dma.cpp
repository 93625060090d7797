#include "boards/pico/dma.hpp"

#include "boards/pico/resets.hpp"

#include <atomic>

namespace kfast::pico::dma {
namespace {

// Channel 0
constexpr Register read_address{0x5000'0000};
constexpr Register write_address{0x5000'0004};
constexpr Register transfer_count{0x5000'0008};
constexpr Register control_and_start{0x5000'000C};
constexpr Register control{0x5000'0010};

constexpr std::uint32_t enabled = 1 << 0;
constexpr std::uint32_t high_priority = 1 << 1;
constexpr int piece_at = 2;
constexpr std::uint32_t read_next = 1 << 4;
constexpr int chain_at = 11;
constexpr std::uint32_t no_chain = 0 << chain_at; // to itself
constexpr int request_at = 15;
constexpr std::uint32_t quiet = 1 << 21; // no interrupt
constexpr std::uint32_t is_busy = 1 << 24;

}

void begin() { resets::restart(resets::dma); }

void start(std::span<const std::byte> bytes, Piece piece, Register target, Request request)
{
    std::atomic_signal_fence(std::memory_order_release); // the bytes are in memory before the unit looks
    const auto width = static_cast<std::uint32_t>(piece);
    read_address.write(reinterpret_cast<std::uintptr_t>(bytes.data()));
    write_address.write(target.address());
    transfer_count.write(static_cast<std::uint32_t>(bytes.size()) >> width);
    control_and_start.write(enabled | high_priority | width << piece_at | read_next | no_chain |
                            static_cast<std::uint32_t>(request) << request_at | quiet);
}

bool busy()
{
    const bool result = (control.read() & is_busy) != 0;
    std::atomic_signal_fence(std::memory_order_acquire); // nobody writes to the bytes before
    return result;
}

}
