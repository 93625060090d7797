#pragma once

#include "firmware/slots/flash.hpp"
#include "tests/known.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <utility>
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
    fickle,      ///< at each start anew: as it was, as it was to be, or each bit as one of both
};

/// How a sector is bad: the five behaviours with which the tests of littlefs pretend bad blocks.
enum class Fault : std::uint8_t {
    none,
    program_error,        ///< programming leaves some bits as they were
    erase_error,          ///< erasing leaves some bits as they were
    read_error,           ///< a bit is read wrongly
    program_does_nothing, ///< without a word
    erase_does_nothing,   ///< without a word
};
inline constexpr std::array every_fault{Fault::program_error, Fault::erase_error, Fault::read_error,
                                        Fault::program_does_nothing, Fault::erase_does_nothing};

/// NOR flash: erasing sets all bits of a sector, programming can only clear bits. Counts what is done to it,
/// may lose its power, and may have bad sectors.
class PretendFlash {
public:
    explicit PretendFlash(std::size_t size)
        : bytes_(size, std::byte{0xFF}), erased_(size / sector_bytes), faults_(size / sector_bytes)
    {
    }

    void erase(std::uint32_t offset)
    {
        expect(offset % sector_bytes == 0 && offset < bytes_.size());
        std::erase_if(fickle_, [=](const Fickle& place) {
            return place.offset / sector_bytes * sector_bytes == offset;
        });
        wear(offset / sector_bytes);
        change(offset, sector_bytes, Failing{Fault::erase_error, Fault::erase_does_nothing},
               [](std::span<std::byte> place) { std::ranges::fill(place, std::byte{0xFF}); });
    }
    void program(std::uint32_t offset, std::span<const std::byte, page_bytes> page)
    {
        expect(offset % page_bytes == 0 && offset < bytes_.size());
        demand_known(page);
        ++programmed_;
        change(offset, page_bytes, Failing{Fault::program_error, Fault::program_does_nothing},
               [=](std::span<std::byte> place) {
                   for (std::size_t at = 0; at < page_bytes; ++at)
                       place[at] &= page[at];
               });
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
    /// A start.
    void power_again()
    {
        until_cut_.reset();
        for (const Fickle& place : fickle_)
            read_anew(place);
    }

    /// From now on the sector at `offset` is bad.
    void spoil(std::uint32_t offset, Fault fault) { faults_[offset / sector_bytes] = fault; }
    /// Every sector turns bad when it is erased more often than that.
    void wear_out_after(int erasures) { endurance_ = erasures; }
    bool is_bad(std::uint32_t offset) const { return faults_[offset / sector_bytes] != Fault::none; }

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

    /// With what faults an operation fails, and with which it does nothing.
    struct Failing {
        Fault error;
        Fault nothing;
    };
    struct Fickle {
        std::uint32_t offset;
        std::vector<std::byte> before;
        std::vector<std::byte> wanted;
    };

    std::byte random_byte() { return static_cast<std::byte>(random_() & 255); }
    static std::byte mixed(std::byte a, std::byte b, std::byte which) { return (a & which) | (b & ~which); }

    void wear(std::uint32_t sector)
    {
        if (++erased_[sector] > endurance_ && faults_[sector] == Fault::none)
            faults_[sector] = every_fault[random_() % every_fault.size()];
    }

    /// Makes of a place what `make` does, or what power and the sector allow.
    template <class Make>
    void change(std::uint32_t offset, std::size_t size, Failing failing, const Make& make)
    {
        const auto place = std::span{bytes_}.subspan(offset, size);
        const Fault fault = faults_[offset / sector_bytes];
        const std::byte read_wrongly{fault == Fault::read_error && offset % sector_bytes == 0};
        std::array<std::byte, sector_bytes> made;
        const auto wanted = std::span{made}.first(size);
        std::ranges::copy(place, wanted.begin());
        wanted[0] ^= read_wrongly;
        make(wanted);
        wanted[0] ^= read_wrongly;
        if (until_cut_ && (*until_cut_)-- == 0) {
            leave_remains(offset, place, wanted);
            throw PowerCut{};
        }
        if (fault == failing.error)
            leave_some_bits(place, wanted);
        else if (fault != failing.nothing)
            std::ranges::copy(wanted, place.begin());
    }

    void leave_remains(std::uint32_t offset, std::span<std::byte> place, std::span<const std::byte> wanted)
    {
        switch (remains_) {
        case Remains::nothing_done:
            break;
        case Remains::random_bits:
            std::ranges::generate(place, [this] { return random_byte(); });
            break;
        case Remains::some_bits:
            leave_some_bits(place, wanted);
            break;
        case Remains::half:
            std::ranges::copy(wanted.first(wanted.size() / 2), place.begin());
            break;
        case Remains::fickle:
            fickle_.push_back({offset, {place.begin(), place.end()}, {wanted.begin(), wanted.end()}});
            break;
        }
    }
    void leave_some_bits(std::span<std::byte> place, std::span<const std::byte> wanted)
    {
        for (std::size_t at = 0; at < place.size(); ++at)
            place[at] = mixed(place[at], wanted[at], random_byte());
    }
    void read_anew(const Fickle& fickle)
    {
        const auto kind = random_() % 4;
        for (std::size_t at = 0; at < fickle.wanted.size(); ++at) {
            const std::byte which = kind == 0 ? std::byte{0xFF} : kind == 1 ? random_byte() : std::byte{0};
            bytes_[fickle.offset + at] = mixed(fickle.before[at], fickle.wanted[at], which);
        }
    }

    std::vector<std::byte> bytes_;
    std::vector<int> erased_;
    std::vector<Fault> faults_;
    std::vector<Fickle> fickle_;
    int programmed_ = 0;
    int endurance_ = std::numeric_limits<int>::max();
    std::optional<int> until_cut_;
    Remains remains_ = Remains::nothing_done;
    std::mt19937 random_;
};

}
