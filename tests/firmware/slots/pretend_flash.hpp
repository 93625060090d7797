#pragma once

#include "firmware/slots/flash.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

namespace kfast::test {

/// Thrown when the power of a pretend flash goes.
struct PowerCut {};

/// What an interrupted operation leaves where it was at work.
enum class Remains {
    nothing_done,
    random_bits, ///< anything at all
    some_bits,   ///< each bit as it was or as it was to be
    half,        ///< the first half done
};

/// NOR flash: erasing sets all bits of a sector, programming can only clear bits. Counts what is done to it,
/// and may lose its power.
class PretendFlash {
public:
    explicit PretendFlash(std::size_t size) : bytes_(size, std::byte{0xFF}), erased_(size / sector_bytes) {}

    void erase(std::uint32_t offset)
    {
        expect(offset % sector_bytes == 0 && offset < bytes_.size());
        change(offset, std::vector<std::byte>(sector_bytes, std::byte{0xFF}));
        ++erased_[offset / sector_bytes];
    }
    void program(std::uint32_t offset, std::span<const std::byte, page_bytes> page)
    {
        expect(offset % page_bytes == 0 && offset < bytes_.size());
        std::vector<std::byte> wanted(page.begin(), page.end());
        for (std::size_t at = 0; at < page_bytes; ++at)
            wanted[at] &= bytes_[offset + at];
        change(offset, wanted);
        ++programmed_;
    }
    std::span<const std::byte> contents() const { return bytes_; }

    /// What a flash may hold that was never written by this firmware.
    void fill_with(std::uint32_t seed)
    {
        std::mt19937 random{seed};
        std::ranges::generate(bytes_, [&] { return static_cast<std::byte>(random() & 255); });
    }
    void damage(std::uint32_t offset, std::byte flipped = std::byte{1}) { bytes_[offset] ^= flipped; }

    /// Power goes in operation `number`, 0 being the next one.
    void cut(int number, Remains remains, std::uint32_t seed)
    {
        until_cut_ = number;
        remains_ = remains;
        random_.seed(seed);
    }
    void power_again() { until_cut_.reset(); }

    /// Operations on all of it, and of these, how often each sector was erased.
    int operations() const { return programmed_ + erased(); }
    int erased() const
    {
        int all = 0;
        for (const int times : erased_)
            all += times;
        return all;
    }
    const std::vector<int>& erased_sectors() const { return erased_; }

private:
    static void expect(bool is_kept)
    {
        if (!is_kept)
            throw std::logic_error{"flash is used against its rules"};
    }

    void change(std::uint32_t offset, const std::vector<std::byte>& wanted)
    {
        const auto place = std::span{bytes_}.subspan(offset, wanted.size());
        if (until_cut_ && (*until_cut_)-- == 0) {
            leave_remains(place, wanted);
            throw PowerCut{};
        }
        std::ranges::copy(wanted, place.begin());
    }

    void leave_remains(std::span<std::byte> place, const std::vector<std::byte>& wanted)
    {
        for (std::size_t at = 0; at < place.size(); ++at) {
            const auto random = static_cast<std::byte>(random_() & 255);
            switch (remains_) {
            case Remains::nothing_done:
                break;
            case Remains::random_bits:
                place[at] = random;
                break;
            case Remains::some_bits:
                place[at] = (place[at] & random) | (wanted[at] & ~random);
                break;
            case Remains::half:
                if (at < place.size() / 2)
                    place[at] = wanted[at];
                break;
            }
        }
    }

    std::vector<std::byte> bytes_;
    std::vector<int> erased_;
    int programmed_ = 0;
    std::optional<int> until_cut_;
    Remains remains_ = Remains::nothing_done;
    std::mt19937 random_;
};

}
