#pragma once

#include <cstdint>

namespace kfast {

/// A 32-bit register of a chip. Every read() and write() happens, in the order written.
class Register {
public:
    explicit constexpr Register(std::uint32_t address) : address_{address} {}

    std::uint32_t read() const { return *pointer(); }
    void write(std::uint32_t value) const { *pointer() = value; }
    void set(std::uint32_t bits) const { write(read() | bits); }
    void clear(std::uint32_t bits) const { write(read() & ~bits); }

private:
    volatile std::uint32_t* pointer() const { return reinterpret_cast<volatile std::uint32_t*>(address_); }

    std::uint32_t address_;
};

}
