// libusb is initialized anew for each look: without udev at work it never sees what is plugged in after its
// initialization.

#include "host/flash/boot_board.hpp"

#include "host/flash/boot_usb_id.hpp"
#include "host/flash/picoboot.hpp"
#include "host/program/failure.hpp"
#include "host/udev/udev.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <libusb-1.0/libusb.h>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace kfast {

namespace {

using std::chrono::milliseconds;

constexpr unsigned control_patience = 3000; ///< in milliseconds
constexpr std::uint8_t halt = 1;            ///< in the status of an endpoint

using Context = std::shared_ptr<libusb_context>;
using Device = std::shared_ptr<libusb_device>; ///< keeps its context
using Handle = std::unique_ptr<libusb_device_handle, decltype(&libusb_close)>;

/// None on a computer without USB.
Context begun_library()
{
    libusb_context* context = nullptr;
    return ::libusb_init(&context) == LIBUSB_SUCCESS ? Context{context, libusb_exit} : Context{};
}

std::vector<Device> attached()
{
    std::vector<Device> devices;
    const Context context = begun_library();
    libusb_device** list = nullptr;
    const auto count = context ? ::libusb_get_device_list(context.get(), &list) : 0;
    for (libusb_device* device : std::span{list, static_cast<std::size_t>(std::max<ssize_t>(count, 0))})
        devices.emplace_back(::libusb_ref_device(device),
                             [context](libusb_device* kept) { ::libusb_unref_device(kept); });
    if (list != nullptr)
        ::libusb_free_device_list(list, 1);
    return devices;
}

libusb_device_descriptor descriptor_of(const Device& device)
{
    libusb_device_descriptor descriptor{};
    ::libusb_get_device_descriptor(device.get(), &descriptor); // never fails, according to its documentation
    return descriptor;
}

std::optional<BootChip> boot_chip(const Device& device)
{
    const libusb_device_descriptor descriptor = descriptor_of(device);
    if (descriptor.idVendor != boot_usb::vendor_id)
        return std::nullopt;
    switch (descriptor.idProduct) {
    case boot_usb::rp2040_id:
        return BootChip::rp2040;
    case boot_usb::rp2350_id:
        return BootChip::rp2350;
    default:
        return std::nullopt;
    }
}

std::string port_of(const Device& device)
{
    constexpr std::size_t deepest = 7; // as USB 3.0 allows
    std::array<std::uint8_t, deepest> ports{};
    const int depth = ::libusb_get_port_numbers(device.get(), ports.data(), ports.size());
    std::string text = std::to_string(::libusb_get_bus_number(device.get()));
    for (int at = 0; at < depth; ++at)
        text += (at == 0 ? '-' : '.') + std::to_string(ports[static_cast<std::size_t>(at)]);
    return text;
}

std::string file_of(const Device& device)
{
    std::array<char, 40> path{};
    std::snprintf(path.data(), path.size(), "/dev/bus/usb/%03u/%03u",
                  unsigned{::libusb_get_bus_number(device.get())},
                  unsigned{::libusb_get_device_address(device.get())});
    return path.data();
}

/// Throws the Failure for that error.
[[noreturn]] void fail(int error)
{
    switch (error) {
    case LIBUSB_ERROR_PIPE:
        throw UsbStall{};
    case LIBUSB_ERROR_TIMEOUT:
        throw Failure{"the boot loader does not answer: plug the board in anew with BOOTSEL held down, and "
                      "flash it again",
                      ExitStatus::timed_out};
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_IO:
        throw Failure{"the board is gone: plug it in with BOOTSEL held down, and flash it again",
                      ExitStatus::unplugged};
    default:
        throw Failure{std::string{"USB fails: "} + ::libusb_strerror(error) +
                          ": plug the board in anew with BOOTSEL held down, and flash it again",
                      ExitStatus::refused};
    }
}

/// The number or length that it represents, unless it is an error.
int checked(int result)
{
    if (result < 0)
        fail(result);
    return result;
}

struct Endpoints {
    std::uint8_t interface = 0;
    std::uint8_t out = 0;
    std::uint8_t in = 0;
};

unsigned time_of(milliseconds patience) { return static_cast<unsigned>(patience.count()); }

class LibusbPipe final : public UsbPipe {
public:
    /// The interface is claimed.
    LibusbPipe(Device device, Handle handle, Endpoints endpoints)
        : device_{std::move(device)}, handle_{std::move(handle)}, endpoints_{endpoints}
    {
    }

    ~LibusbPipe() override { ::libusb_release_interface(handle_.get(), endpoints_.interface); }

    void send(std::span<const std::byte> bytes, milliseconds patience) override
    {
        auto* const data = reinterpret_cast<unsigned char*>(const_cast<std::byte*>(bytes.data()));
        transfer(endpoints_.out, data, bytes.size(), patience); // which it only reads
    }

    std::size_t receive(std::span<std::byte> bytes, milliseconds patience) override
    {
        return transfer(endpoints_.in, reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(),
                        patience);
    }

    void control_write(std::uint8_t request, milliseconds patience) override
    {
        control(LIBUSB_ENDPOINT_OUT, request, {}, patience);
    }

    std::size_t ask(std::uint8_t request, std::span<std::byte> answer, milliseconds patience) override
    {
        return control(LIBUSB_ENDPOINT_IN, request, answer, patience);
    }

    void clear_halts() override
    {
        for (const std::uint8_t endpoint : {endpoints_.out, endpoints_.in})
            if (is_halted(endpoint))
                checked(::libusb_clear_halt(handle_.get(), endpoint));
    }

private:
    std::size_t transfer(std::uint8_t endpoint, unsigned char* data, std::size_t size, milliseconds patience)
    {
        int count = 0;
        checked(::libusb_bulk_transfer(handle_.get(), endpoint, data, static_cast<int>(size), &count,
                                       time_of(patience)));
        return static_cast<std::size_t>(count);
    }

    std::size_t control(int direction, std::uint8_t request, std::span<std::byte> bytes,
                        milliseconds patience)
    {
        const int type = direction | int{LIBUSB_REQUEST_TYPE_VENDOR} | int{LIBUSB_RECIPIENT_INTERFACE};
        return static_cast<std::size_t>(checked(
            ::libusb_control_transfer(handle_.get(), static_cast<std::uint8_t>(type), request, 0,
                                      endpoints_.interface, reinterpret_cast<unsigned char*>(bytes.data()),
                                      static_cast<std::uint16_t>(bytes.size()), time_of(patience))));
    }

    bool is_halted(std::uint8_t endpoint)
    {
        constexpr int type =
            int{LIBUSB_ENDPOINT_IN} | int{LIBUSB_REQUEST_TYPE_STANDARD} | int{LIBUSB_RECIPIENT_ENDPOINT};
        std::array<unsigned char, 2> status{};
        const int count = ::libusb_control_transfer(
            handle_.get(), static_cast<std::uint8_t>(type), LIBUSB_REQUEST_GET_STATUS, 0, endpoint,
            status.data(), static_cast<std::uint16_t>(status.size()), control_patience);
        return checked(count) == static_cast<int>(status.size()) && (status[0] & halt) != 0;
    }

    Device device_;
    Handle handle_;
    Endpoints endpoints_;
};

/// The endpoints of the interface, if it is one of PICOBOOT.
std::optional<Endpoints> endpoints_of(const libusb_interface_descriptor& interface)
{
    if (interface.bInterfaceClass != LIBUSB_CLASS_VENDOR_SPEC || interface.bNumEndpoints != 2)
        return std::nullopt;
    Endpoints found{interface.bInterfaceNumber, 0, 0};
    for (const libusb_endpoint_descriptor& endpoint :
         std::span{interface.endpoint, interface.bNumEndpoints}) {
        const bool is_in = (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_IN) != 0;
        if ((endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) == LIBUSB_TRANSFER_TYPE_BULK)
            (is_in ? found.in : found.out) = endpoint.bEndpointAddress;
    }
    return found.in != 0 && found.out != 0 ? std::optional{found} : std::nullopt;
}

/// The second interface; the first one where the boot loader was started without its drive.
Endpoints picoboot_endpoints(const Device& device)
{
    libusb_config_descriptor* read = nullptr;
    checked(::libusb_get_active_config_descriptor(device.get(), &read));
    const std::unique_ptr<libusb_config_descriptor, decltype(&libusb_free_config_descriptor)> config{
        read, libusb_free_config_descriptor};
    const std::span interfaces{config->interface, config->bNumInterfaces};
    const std::size_t place = interfaces.size() == 1 ? 0 : 1;
    if (place < interfaces.size() && interfaces[place].num_altsetting > 0)
        if (const auto endpoints = endpoints_of(interfaces[place].altsetting[0]))
            return *endpoints;
    throw NoPicoboot{};
}

Handle opened(const Device& device)
{
    libusb_device_handle* handle = nullptr;
    const int error = ::libusb_open(device.get(), &handle);
    if (error == LIBUSB_ERROR_ACCESS)
        throw not_allowed(file_of(device), "\"0003\"");
    checked(error);
    return Handle{handle, libusb_close};
}

void claim(const Handle& handle, std::uint8_t interface)
{
    const int error = ::libusb_claim_interface(handle.get(), interface);
    if (error == LIBUSB_ERROR_BUSY)
        throw Failure{
            "another program has the boot loader: end that (picotool, another kfast), and try again",
            ExitStatus::refused};
    checked(error);
}

Device device_at(const BootBoard& board)
{
    for (const Device& device : attached())
        if (boot_chip(device) == board.chip && port_of(device) == board.port)
            return device;
    throw Failure{"the board at the port " + board.port +
                      " is gone: plug it in with BOOTSEL held down, and try again",
                  ExitStatus::no_device};
}

}

std::vector<BootBoard> boards_in_boot_loader()
{
    std::vector<BootBoard> boards;
    for (const Device& device : attached())
        if (const auto chip = boot_chip(device))
            boards.push_back({*chip, port_of(device)});
    std::ranges::sort(boards, {}, &BootBoard::port);
    return boards;
}

std::unique_ptr<BootLoader> open_boot_loader(const BootBoard& board)
{
    if (board.chip != BootChip::rp2040)
        throw Failure{"the board at the port " + board.port +
                          " has an RP2350, and the firmware is for the RP2040: take a board with that, a "
                          "Raspberry Pi Pico",
                      ExitStatus::wrong_chip};
    const Device device = device_at(board);
    Handle handle = opened(device);
    const Endpoints endpoints = picoboot_endpoints(device);
    claim(handle, endpoints.interface);
    return std::make_unique<PicobootLoader>(
        std::make_unique<LibusbPipe>(device, std::move(handle), endpoints));
}

}
