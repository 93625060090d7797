#pragma once

#include <cstdint>

extern "C" {
// From the linker script: addresses in 16 bits.
extern const volatile std::uint16_t rom_function_table;
extern const volatile std::uint16_t rom_table_lookup;
}

/// The functions that the boot ROM has for programs.
namespace kfast::pico::boot_rom {

/// By its name: two letters.
template <class Function>
Function* function(char first, char second)
{
    using Lookup = std::uint32_t(std::uint32_t table, std::uint32_t name);
    auto* const look_up = reinterpret_cast<Lookup*>(std::uint32_t{rom_table_lookup});
    const std::uint32_t name = static_cast<std::uint32_t>(first) | static_cast<std::uint32_t>(second) << 8;
    return reinterpret_cast<Function*>(look_up(rom_function_table, name));
}

/// Starts the chip anew as a drive for UF2 files.
[[noreturn]] inline void become_drive()
{
    using Restart = void(std::uint32_t activity_pins, std::uint32_t disabled_interfaces);
    function<Restart>('U', 'B')(0, 0);
    while (true)
        asm volatile("wfe");
}

}
