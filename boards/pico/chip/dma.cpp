#include "boards/pico/chip/dma.hpp"

#include "boards/pico/chip/resets.hpp"

#include <atomic>

namespace kfast::pico::dma {
namespace {

constexpr Channel channel{0};

}

void begin() { resets::restart(resets::dma); }

void start(std::span<const std::byte> bytes, DataSize piece, Register target, Dreq request)
{
    std::atomic_signal_fence(std::memory_order_release); // the bytes are in memory before the unit looks
    const auto width = static_cast<std::uint32_t>(piece);
    channel.read_addr().write(reinterpret_cast<std::uintptr_t>(bytes.data()));
    channel.write_addr().write(target.address());
    channel.trans_count().write(static_cast<std::uint32_t>(bytes.size()) >> width);
    channel.ctrl_trig().write(ctrl_en | ctrl_high_priority | ctrl_data_size(piece) | ctrl_incr_read |
                              ctrl_chain_to(channel) | ctrl_treq_sel(request) | ctrl_irq_quiet);
}

bool busy()
{
    const bool result = (channel.al1_ctrl().read() & ctrl_busy) != 0;
    std::atomic_signal_fence(std::memory_order_acquire); // nothing writes to the bytes before
    return result;
}

}
