#pragma once

#include "tests/host/flash/nor_flash.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>

namespace kfast::test {

/// The drive of the boot ROM of an RP2040: what it makes of the blocks of 512 bytes that are written to it.
class Uf2Rom {
public:
    explicit Uf2Rom(NorFlash& flash) : flash_{flash} {}

    void take(std::span<const std::byte> block);

    bool has_restarted = false;

private:
    NorFlash& flash_;
    std::uint32_t count_ = 0;            ///< of the blocks of this transfer; none is under way
    std::set<std::uint32_t> numbers_;    ///< that it has had
    std::set<std::uint32_t> erased_for_; ///< numbers x 256 / 4096
};

}
