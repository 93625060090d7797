#pragma once

#include "host/flash/boot_board.hpp"
#include "host/program/failure.hpp"
#include "tests/host/flash/nor_flash.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>

namespace kfast::test {

/// A boot loader of a flash in this memory. It can be unplugged, and lie.
class PretendBootLoader final : public BootLoader {
public:
    static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

    explicit PretendBootLoader(NorFlash& flash) : flash_{flash} {}

    void read(std::uint32_t address, std::span<std::byte> bytes) override
    {
        step();
        std::ranges::copy(flash_.read(address, bytes.size()), bytes.begin());
        if (after_read)
            after_read(address, bytes);
    }

    void erase(std::uint32_t address, std::size_t bytes) override
    {
        for (std::size_t offset = 0; offset < bytes; offset += NorFlash::sector_bytes) {
            step();
            changed = true;
            flash_.erase_sector(address + static_cast<std::uint32_t>(offset));
        }
    }

    void write(std::uint32_t address, std::span<const std::byte> bytes) override
    {
        for (std::size_t offset = 0; offset < bytes.size(); offset += NorFlash::page_bytes) {
            step();
            changed = true;
            flash_.program_page(address + static_cast<std::uint32_t>(offset),
                                bytes.subspan(offset, NorFlash::page_bytes));
        }
    }

    void restart() override {}

    std::size_t steps = 0;               ///< sectors read and erased, pages written
    std::size_t unplugged_after = never; ///< so many steps
    bool changed = false;                ///< something was erased or written
    std::function<void(std::uint32_t address, std::span<std::byte> bytes)> after_read;

private:
    void step()
    {
        if (steps == unplugged_after)
            throw Failure{"unplugged", ExitStatus::unplugged};
        ++steps;
    }

    NorFlash& flash_;
};

}
