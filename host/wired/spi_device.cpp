#include "host/wired/spi_device.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <linux/spi/spidev.h>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace kfast {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

Failure no_such_device(const std::string& path)
{
    const std::string present = present_spi_devices();
    const std::string hint = present.empty()
                                 ? std::string{"there is no SPI device at all: "} + how_to_enable_spi
                                 : "there is " + present;
    return Failure{path + " is no SPI device: " + hint, ExitStatus::no_device};
}

Failure cannot_open(const std::string& path, int error)
{
    switch (error) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case ENOTTY:
        return no_such_device(path);
    case EACCES:
    case EPERM:
        return Failure{"you may not open " + path +
                           ": where there is a group 'spi', join it and log in again (sudo usermod -aG spi "
                           "$USER); elsewhere a rule of udev allows it:\n  SUBSYSTEM==\"spidev\", "
                           "TAG+=\"uaccess\", GROUP=\"plugdev\", MODE=\"0660\"",
                       ExitStatus::no_permission};
    case EBUSY:
        return Failure{path + " is in use: end the program that has it ('fuser " + path + "' tells which)",
                       ExitStatus::refused};
    default:
        return Failure{path + " cannot be opened: " + reason(error), ExitStatus::refused};
    }
}

Failure cannot_write(const std::string& path, int error, std::size_t bytes)
{
    switch (error) {
    case ENODEV:
    case ENXIO:
    case ESHUTDOWN:
        return Failure{path + " is gone: was its driver unbound?", ExitStatus::unplugged};
    case EMSGSIZE:
        return Failure{path + " does not take " + std::to_string(bytes) +
                           " bytes at once: begin the computer with spidev.bufsiz=65536 in the kernel's "
                           "command line",
                       ExitStatus::refused};
    default:
        return Failure{path + ": the transfer failed: " + reason(error), ExitStatus::refused};
    }
}

/// The size of spidev's buffer; its default size if the kernel does not report it.
std::size_t buffer_size()
{
    constexpr std::size_t default_size = 4096;
    std::size_t size = 0;
    std::ifstream{"/sys/module/spidev/parameters/bufsiz"} >> size;
    return size == 0 ? default_size : size;
}

int open_device(const std::string& path)
{
    const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0)
        throw cannot_open(path, errno);
    return file;
}

}

std::string present_spi_devices()
{
    std::vector<std::string> paths;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator{"/dev", ignored})
        if (entry.path().filename().string().starts_with("spidev"))
            paths.push_back(entry.path().string());
    std::ranges::sort(paths);
    std::string list;
    for (const std::string& path : paths)
        list += (list.empty() ? "" : ", ") + path;
    return list;
}

SpiDevice::SpiDevice(const SpiSettings& settings)
    : path_{settings.path}, file_{open_device(settings.path)}, piece_{buffer_size()}
{
    try {
        configure(settings);
    } catch (...) {
        ::close(file_);
        throw;
    }
}

SpiDevice::~SpiDevice() { ::close(file_); }

void SpiDevice::configure(const SpiSettings& settings)
{
    std::uint8_t mode = settings.mode == 3 ? SPI_MODE_3 : SPI_MODE_0;
    if (!settings.drives_select)
        mode |= SPI_NO_CS;
    std::uint8_t bits = 8;
    std::uint32_t clock = settings.clock;
    if (::ioctl(file_, SPI_IOC_WR_MODE, &mode) != 0) {
        if (errno == ENOTTY)
            throw no_such_device(path_);
        throw Failure{path_ + " does not do SPI mode " + std::to_string(settings.mode) +
                          (settings.drives_select ? "" : " without its own chip select") + ": " +
                          reason(errno),
                      ExitStatus::refused};
    }
    if (::ioctl(file_, SPI_IOC_WR_BITS_PER_WORD, &bits) != 0 ||
        ::ioctl(file_, SPI_IOC_WR_MAX_SPEED_HZ, &clock) != 0 ||
        ::ioctl(file_, SPI_IOC_RD_MAX_SPEED_HZ, &clock_) != 0)
        throw Failure{path_ + " does not take a clock of " + std::to_string(settings.clock) +
                          " Hz: " + reason(errno) + ": try a slower one",
                      ExitStatus::refused};
}

void SpiDevice::write(std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const auto now = bytes.first(std::min(bytes.size(), piece_));
        transfer(now);
        bytes = bytes.subspan(now.size());
    }
}

void SpiDevice::transfer(std::span<const std::byte> bytes)
{
    spi_ioc_transfer transfer{};
    transfer.tx_buf = reinterpret_cast<std::uintptr_t>(bytes.data());
    transfer.len = static_cast<std::uint32_t>(bytes.size());
    if (::ioctl(file_, SPI_IOC_MESSAGE(1), &transfer) < 0)
        throw cannot_write(path_, errno, bytes.size());
}

}
