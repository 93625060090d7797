#include "boards/pico/beam/looped_words.hpp"

#include "boards/pico/chip/resets.hpp"

#include <atomic>

namespace kfast::pico::looped_words {
namespace {

// When `words` has sent the last one it has `chooser` look which loop is next. That writes where it is
// described to `starter`, and so starts it; that writes the description to `words`, and so starts that. The
// processor changes one word, `next`: there is no time at which it could be wrong.
constexpr dma::Channel words{0};
constexpr dma::Channel chooser{1};
constexpr dma::Channel starter{2};

constexpr std::uint32_t always =
    dma::ctrl_en | dma::ctrl_high_priority | dma::ctrl_data_size(dma::DataSize::word) | dma::ctrl_irq_quiet;
constexpr std::uint32_t unpaced = always | dma::ctrl_treq_sel(dma::Dreq::permanent);

static_assert(sizeof(Loop) == 8);
constexpr std::uint32_t bits_of_loop = 3;

const Loop* volatile next;

std::uint32_t address_of(const volatile void* object)
{
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(object));
}

}

void begin(const Loop& first, Register target, dma::Dreq request)
{
    resets::restart(resets::dma);
    go_over_to(first);
    words.write_addr().write(target.address());
    words.al1_ctrl().write(always | dma::ctrl_incr_read | dma::ctrl_chain_to(chooser) |
                           dma::ctrl_treq_sel(request));
    starter.write_addr().write(words.al3_trans_count().address());
    starter.trans_count().write(sizeof(Loop) / 4);
    starter.al1_ctrl().write(unpaced | dma::ctrl_incr_read | dma::ctrl_incr_write |
                             dma::ctrl_ring_write(bits_of_loop) | dma::ctrl_chain_to(starter));
    chooser.read_addr().write(address_of(&next));
    chooser.write_addr().write(starter.al3_read_addr_trig().address());
    chooser.trans_count().write(1);
    chooser.ctrl_trig().write(unpaced | dma::ctrl_chain_to(chooser));
}

void go_over_to(const Loop& loop)
{
    std::atomic_signal_fence(std::memory_order_release); // it is in memory before the unit looks
    next = &loop;
}

// While `starter` reads it points elsewhere: to the beginning of a loop or its middle. The beginning of the
// one that runs is not the end of the one that was requested, as these are not adjacent.
bool has_gone_over()
{
    const bool result = starter.read_addr().read() == address_of(next + 1);
    std::atomic_signal_fence(std::memory_order_acquire); // nothing writes to the words before
    return result;
}

}
