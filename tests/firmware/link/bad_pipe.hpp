#pragma once

#include "firmware/link/checksum.hpp"
#include "firmware/link/message_kind.hpp"
#include "firmware/report.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace kfast::test {

/// How bad a pipe is: how many of 1000 reports suffer what.
struct Badness {
    std::uint32_t lost = 0;
    std::uint32_t repeated = 0;
    std::uint32_t overtaken = 0; ///< by the one behind it
    std::uint32_t truncated = 0;
    std::uint32_t damaged = 0; ///< a byte of it
    std::uint32_t garbage = 0; ///< another one comes besides, of random bytes or invented
};

/// Brings reports from one end to the other, badly.
class BadPipe {
public:
    using Bytes = std::vector<std::byte>;

    BadPipe(const Badness& badness, std::uint32_t seed) : badness_{badness}, random_{seed} {}

    void put(const Report& report)
    {
        Bytes bytes(report.bytes.begin(), report.bytes.end());
        if (happens(badness_.garbage))
            on_the_way_.push_back(happens(500) ? garbage() : invented());
        if (happens(badness_.lost))
            return;
        if (happens(badness_.truncated))
            bytes.resize(below(report_bytes));
        else if (happens(badness_.damaged))
            bytes[below(report_bytes)] ^= static_cast<std::byte>(1 + below(255));
        if (happens(badness_.repeated))
            on_the_way_.push_back(bytes);
        on_the_way_.push_back(std::move(bytes));
        if (on_the_way_.size() > 1 && happens(badness_.overtaken))
            std::swap(on_the_way_.back(), on_the_way_[on_the_way_.size() - 2]);
    }

    std::optional<Bytes> next()
    {
        if (on_the_way_.empty())
            return std::nullopt;
        Bytes bytes = std::move(on_the_way_.front());
        on_the_way_.pop_front();
        return bytes;
    }

private:
    std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
    bool happens(std::uint32_t of_1000) { return below(1000) < of_1000; }
    Bytes garbage()
    {
        Bytes bytes(report_bytes);
        for (std::byte& byte : bytes)
            byte = static_cast<std::byte>(below(256));
        bytes[0] &= std::byte{0x3F}; // more of it means something
        return bytes;
    }

    /// Would change what the device keeps, but for its checksum: that of none is right.
    Bytes invented()
    {
        Bytes bytes = garbage();
        constexpr std::array kinds{link::Kind::begin, link::Kind::commit,  link::Kind::cancel,
                                   link::Kind::erase, link::Kind::choose,  link::Kind::arm,
                                   link::Kind::play,  link::Kind::silence, link::Kind::boot_loader};
        bytes[0] = static_cast<std::byte>(kinds[below(kinds.size())]);
        bytes[1] = static_cast<std::byte>(below(4));
        bytes[2] = static_cast<std::byte>(below(8));
        Report report;
        std::ranges::copy(bytes, report.bytes.begin());
        if (link::is_whole(report))
            bytes.back() ^= std::byte{1};
        return bytes;
    }

    Badness badness_;
    std::mt19937 random_;
    std::deque<Bytes> on_the_way_;
};

}
