#include "boards/pico/beam/looped_words.hpp"

#include "boards/pico/chip/resets.hpp"

#include <atomic>

namespace kfast::pico::looped_words {
namespace {

// When `words` has sent the last one it has `chooser` look which loop is next. That writes where it is
// described to `starter`, and so starts it; that writes the description to `words`, and so starts that. The
// processor changes one word, `next`: there is no moment at which it could be wrong.
constexpr dma::Channel words{0};
constexpr dma::Channel chooser{1};
constexpr dma::Channel starter{2};

constexpr std::uint32_t always =
    dma::enabled | dma::high_priority | dma::piece_of(dma::Piece::word_32) | dma::quiet;
constexpr std::uint32_t unpaced = always | dma::paced_by(dma::Request::nobody);

static_assert(sizeof(Loop) == 8);
constexpr std::uint32_t bits_of_loop = 3;

const Loop* volatile next;

std::uint32_t address_of(const volatile void* object)
{
    return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(object));
}

}

void begin(const Loop& first, Register target, dma::Request request)
{
    resets::restart(resets::dma);
    go_over_to(first);
    words.write_address().write(target.address());
    words.control().write(always | dma::read_next | dma::chain_to(chooser) | dma::paced_by(request));
    starter.write_address().write(words.transfer_count_before_start().address());
    starter.transfer_count().write(sizeof(Loop) / 4);
    starter.control().write(unpaced | dma::read_next | dma::write_next | dma::write_round(bits_of_loop) |
                            dma::chain_to(starter));
    chooser.read_address().write(address_of(&next));
    chooser.write_address().write(starter.read_address_and_start().address());
    chooser.transfer_count().write(1);
    chooser.control_and_start().write(unpaced | dma::chain_to(chooser));
}

void go_over_to(const Loop& loop)
{
    std::atomic_signal_fence(std::memory_order_release); // it is in memory before the unit looks
    next = &loop;
}

// While `starter` reads it stands elsewhere: at the beginning of a loop or in its middle. The beginning of
// the one that runs is not the end of what was asked for, as these do not lie side by side.
bool has_gone_over()
{
    const bool result = starter.read_address().read() == address_of(next + 1);
    std::atomic_signal_fence(std::memory_order_acquire); // nobody writes to the words before
    return result;
}

}
