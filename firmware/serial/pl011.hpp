#pragma once

#include "firmware/chip/register.hpp"

#include <cstdint>

namespace kfast {

/// The UART PL011, which chips of many makers have. Its clock and its pins are the board's to give. A
/// Console.
class Pl011 {
public:
    /// Where its registers begin.
    explicit constexpr Pl011(std::uint32_t address)
        : data_{address}, flags_{address + 0x18}, whole_divisor_{address + 0x24}, rest_of_divisor_{address +
                                                                                                   0x28},
          line_{address + 0x2C}, control_{address + 0x30}, interrupts_{address + 0x38}
    {
    }

    /// For begin(): clock / (16 x baud) in 1/64, rounded. `clock_hz` is at most 1 GHz.
    static constexpr std::uint32_t divisor(std::uint32_t clock_hz, std::uint32_t baud)
    {
        return (clock_hz * 4 + baud / 2) / baud;
    }

    /// 8 bits, no parity. Bytes that came before are lost.
    void begin(std::uint32_t divisor) const
    {
        control_.write(0);
        whole_divisor_.write(divisor / 64);
        rest_of_divisor_.write(divisor % 64);
        line_.write(0x70);     // 8 bits, FIFO on
        control_.write(0x301); // receiver, transmitter, on
    }

    /// Whether write() need not wait.
    bool can_transmit() const { return (flags_.read() & transmit_full) == 0; }
    /// Whether bytes are still on their way.
    bool is_sending() const { return (flags_.read() & busy) != 0; }
    /// Whether it interrupts when much of what was written has been sent.
    void interrupt_for_room(bool does) const { interrupts_.write(does ? room_interrupt : 0); }

    void write(char letter) const
    {
        while (!can_transmit()) {
        }
        data_.write(static_cast<std::uint8_t>(letter));
    }

    bool pending() const { return (flags_.read() & receive_empty) == 0; }

    char read() const
    {
        while (!pending()) {
        }
        return static_cast<char>(data_.read());
    }

private:
    static constexpr std::uint32_t busy = 1 << 3;
    static constexpr std::uint32_t receive_empty = 1 << 4;
    static constexpr std::uint32_t transmit_full = 1 << 5;
    static constexpr std::uint32_t room_interrupt = 1 << 5;

    Register data_;
    Register flags_;
    Register whole_divisor_;
    Register rest_of_divisor_;
    Register line_;
    Register control_;
    Register interrupts_;
};

}
