#include "firmware/link/transfer.hpp"

#include "core/bytes/expects.hpp"

#include <algorithm>
#include <utility>

namespace kfast::link {

void Transfer::begin(const Begin& what, std::uint8_t tag, Microseconds now)
{
    expects(blocks_of(what.size) <= max_blocks);
    forget();
    state_ = State::under_way;
    tag_ = tag;
    what_ = what;
    blocks_ = static_cast<std::uint16_t>(blocks_of(what.size));
    progressed_ = now;
}

bool Transfer::is_wanted(std::uint16_t block)
{
    if (block == next_ && next_ != blocks_)
        return true;
    if (block < next_) {
        acknowledge_soon(); // perhaps the acknowledgement was lost
    } else if (untimely_++ % acknowledge_every == 0) {
        is_missing_ = true;
        acknowledge_soon();
    }
    return false;
}

/// The part of the scene that `data`, the next block, is.
std::span<const std::byte> Transfer::next_bytes(const Data& data, Microseconds now)
{
    const std::size_t left = what_.size - next_ * block_bytes;
    const auto bytes = std::span{data.bytes}.first(std::min(left, block_bytes));
    crc_.add(bytes);
    ++next_;
    untimely_ = 0;
    is_missing_ = false;
    progressed_ = now;
    if (++unacknowledged_ == acknowledge_every || next_ == blocks_)
        acknowledge_soon();
    return bytes;
}

void Transfer::end(Status result)
{
    state_ = State::ended;
    result_ = result;
    acknowledged_ = Acknowledged::all;
}

std::optional<Acknowledgement> Transfer::next_acknowledgement()
{
    if (!has_acknowledgement())
        return std::nullopt;
    acknowledged_ = Acknowledged::all;
    unacknowledged_ = 0;
    return Acknowledgement{.next = next_, .window = window, .is_missing = std::exchange(is_missing_, false)};
}

}
