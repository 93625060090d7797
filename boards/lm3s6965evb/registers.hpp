#pragma once

#include <cstdint>

namespace kfast::lm3s6965evb {

/// A 32-bit register of the chip. Every read() and write() happens, in the order written.
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

// System control
inline constexpr Register ris{0x400F'E050};
inline constexpr Register rcc{0x400F'E060};
inline constexpr Register rcgc1{0x400F'E104};
inline constexpr Register rcgc2{0x400F'E108};

// Port A: UART0 and SSI0
inline constexpr Register gpio_a_afsel{0x4000'4420};
inline constexpr Register gpio_a_den{0x4000'451C};

// Port C: PC7 is D/C of the display
inline constexpr Register gpio_c_pin7{0x4000'6000 + (0x80 << 2)}; // a write changes this pin alone
inline constexpr Register gpio_c_dir{0x4000'6400};
inline constexpr Register gpio_c_den{0x4000'651C};

// SSI0 (PL022)
inline constexpr Register ssi_cr0{0x4000'8000};
inline constexpr Register ssi_cr1{0x4000'8004};
inline constexpr Register ssi_dr{0x4000'8008};
inline constexpr Register ssi_sr{0x4000'800C};
inline constexpr Register ssi_cpsr{0x4000'8010};
inline constexpr Register ssi_im{0x4000'8014};

// UART0 (PL011)
inline constexpr Register uart_dr{0x4000'C000};
inline constexpr Register uart_fr{0x4000'C018};
inline constexpr Register uart_ibrd{0x4000'C024};
inline constexpr Register uart_fbrd{0x4000'C028};
inline constexpr Register uart_lcrh{0x4000'C02C};
inline constexpr Register uart_ctl{0x4000'C030};

// The CPU's own
inline constexpr Register systick_control{0xE000'E010};
inline constexpr Register systick_reload{0xE000'E014};
inline constexpr Register systick_value{0xE000'E018};
inline constexpr Register nvic_enable{0xE000'E100};
inline constexpr Register cpacr{0xE000'ED88};

}
