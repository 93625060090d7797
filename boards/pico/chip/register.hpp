#pragma once

#include <cstdint>

namespace kfast::pico {

/// A 32-bit register of the RP2040. Every access happens, in the order written.
class Register {
public:
    explicit constexpr Register(std::uint32_t address) : address_{address} {}

    constexpr std::uint32_t address() const { return address_; }
    std::uint32_t read() const { return at(0); }
    void write(std::uint32_t value) const { at(0) = value; }

    // In one bus access each, through the aliases that all units but SIO and the processor's own have.
    void set(std::uint32_t bits) const { at(0x2000) = bits; }
    void clear(std::uint32_t bits) const { at(0x3000) = bits; }

private:
    volatile std::uint32_t& at(std::uint32_t alias) const
    {
        return *reinterpret_cast<volatile std::uint32_t*>(address_ + alias);
    }

    std::uint32_t address_;
};

}
