#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace kfast {

struct SpiSettings {
    std::string path;          ///< /dev/spidev0.0
    std::uint32_t clock = 0;   ///< bits a second, not 0
    int mode = 0;              ///< 0 or 3: displays take bits at the rising edge
    bool drives_select = true; ///< else the bus's own chip select line stays as it is
};

/// Where SPI is switched on, for messages.
inline constexpr const char* how_to_enable_spi =
    "on a Raspberry Pi, 'sudo raspi-config' enables SPI under Interface Options (dtparam=spi=on in "
    "config.txt)";

/// "/dev/spidev0.0, /dev/spidev0.1"; empty: there is none.
std::string present_spi_devices();

/// A device of Linux's spidev, written to alone.
class SpiDevice {
public:
    /// Throws Failure: with no_device, with no_permission, and with refused if mode or clock cannot be set.
    explicit SpiDevice(const SpiSettings& settings);
    ~SpiDevice();
    SpiDevice(const SpiDevice&) = delete;
    SpiDevice& operator=(const SpiDevice&) = delete;

    /// In as many transfers as the kernel's buffer needs; chip select goes low again for each. Throws
    /// Failure: with unplugged if the device is gone, else with refused.
    void write(std::span<const std::byte> bytes);

    /// As the kernel reports it; its driver uses the next lower clock that the chip can make.
    std::uint32_t clock() const { return clock_; }
    /// The maximum number of bytes in a transfer.
    std::size_t piece() const { return piece_; }

private:
    void configure(const SpiSettings& settings);
    void transfer(std::span<const std::byte> bytes);

    std::string path_;
    int file_;
    std::uint32_t clock_ = 0;
    std::size_t piece_;
};

}
