#include "tests/emulation/linux/devices.hpp"
#include "tests/emulation/linux/stand_in_root.hpp"
#include "tests/emulation/linux/wires.hpp"

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <linux/spi/spidev.h>

namespace kfast::test {
namespace {

std::string hex(const std::uint8_t* bytes, std::size_t count)
{
    constexpr const char* digits = "0123456789abcdef";
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += digits[bytes[i] >> 4];
        text += digits[bytes[i] & 15];
    }
    return text;
}

class SpiFile final : public StandInFile {
public:
    explicit SpiFile(const char* name)
        : name_{name}, description_{described(stand_in_root() + "/dev/" + name)}
    {
    }

    int control(unsigned long request, void* argument) override
    {
        switch (request) {
        case SPI_IOC_WR_MODE:
            return set_mode(*static_cast<std::uint8_t*>(argument));
        case SPI_IOC_WR_BITS_PER_WORD:
            return *static_cast<std::uint8_t*>(argument) == 8 ? 0 : EINVAL;
        case SPI_IOC_WR_MAX_SPEED_HZ:
            clock_ = *static_cast<std::uint32_t*>(argument);
            return clock_ >= slowest() ? 0 : EINVAL;
        case SPI_IOC_RD_MAX_SPEED_HZ:
            *static_cast<std::uint32_t*>(argument) = clock_;
            return 0;
        case SPI_IOC_MESSAGE(1):
            return send(*static_cast<const spi_ioc_transfer*>(argument));
        default:
            return ENOTTY;
        }
    }

private:
    std::uint32_t slowest() const
    {
        return static_cast<std::uint32_t>(number_of(description_, "slowest", 1));
    }

    int set_mode(std::uint8_t mode)
    {
        if ((mode & SPI_NO_CS) != 0 && description_.contains("always-selects"))
            return EINVAL;
        write_wires("mode " + name_ + ' ' + std::to_string(mode));
        return 0;
    }

    int send(const spi_ioc_transfer& transfer)
    {
        if (gone_after_ == 0)
            return ESHUTDOWN;
        if (gone_after_ > 0)
            --gone_after_;
        if (transfer.len > static_cast<std::uint32_t>(number_of(description_, "most", 4096)))
            return EMSGSIZE;
        if (++transfers_ == interrupted_at_)
            std::raise(SIGINT);
        const auto* const bytes = reinterpret_cast<const std::uint8_t*>(transfer.tx_buf);
        write_wires("spi " + name_ + ' ' + hex(bytes, transfer.len));
        pass_time(number_of(description_, "nanoseconds-per-byte", 0) * transfer.len);
        return 0;
    }

    std::string name_;
    std::multimap<std::string, std::string> description_;
    std::uint32_t clock_ = 0;
    long interrupted_at_ = number_of(description_, "interrupted-at", 0);
    long transfers_ = 0;
    long gone_after_ = number_of(description_, "gone-after", -1);
};

}

StandInFile* spi_device(const char* name) { return new SpiFile{name}; }

}
