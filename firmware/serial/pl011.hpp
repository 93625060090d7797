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
        : uartdr_{address},
          uartfr_{address + 0x18},
          uartibrd_{address + 0x24},
          uartfbrd_{address + 0x28},
          uartlcr_h_{address + 0x2C},
          uartcr_{address + 0x30},
          uartimsc_{address + 0x38}
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
        uartcr_.write(0);
        uartibrd_.write(divisor / 64);
        uartfbrd_.write(divisor % 64);
        uartlcr_h_.write(0x70); // 8 bits, FIFO on
        uartcr_.write(0x301);   // receiver, transmitter, on
    }

    /// Whether write() need not wait.
    bool can_transmit() const { return (uartfr_.read() & uartfr_txff) == 0; }
    /// Whether bytes are still on their way.
    bool is_sending() const { return (uartfr_.read() & uartfr_busy) != 0; }
    /// Whether it interrupts when much of what was written has been sent.
    void interrupt_for_room(bool does) const { uartimsc_.write(does ? uartimsc_txim : 0); }

    void write(char letter) const
    {
        while (!can_transmit()) {
        }
        uartdr_.write(static_cast<std::uint8_t>(letter));
    }

    bool pending() const { return (uartfr_.read() & uartfr_rxfe) == 0; }

    char read() const
    {
        while (!pending()) {
        }
        return static_cast<char>(uartdr_.read());
    }

private:
    static constexpr std::uint32_t uartfr_busy = 1 << 3;
    static constexpr std::uint32_t uartfr_rxfe = 1 << 4;
    static constexpr std::uint32_t uartfr_txff = 1 << 5;
    static constexpr std::uint32_t uartimsc_txim = 1 << 5;

    Register uartdr_;
    Register uartfr_;
    Register uartibrd_;
    Register uartfbrd_;
    Register uartlcr_h_;
    Register uartcr_;
    Register uartimsc_;
};

}
