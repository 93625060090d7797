#include "tests/host/flash/pretend_libusb.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <libusb-1.0/libusb.h>
#include <memory>
#include <span>
#include <utility>
#include <vector>

using namespace kfast;
using namespace kfast::test;

struct libusb_context {
    std::vector<PluggedIn> seen; ///< when it was begun: nothing that comes later
};

struct libusb_device {
    PluggedIn facts;
    int users = 1;
};

struct libusb_device_handle {
    libusb_device* device;
    int claimed = -1;
};

namespace {

constexpr std::uint8_t out_endpoint = 0x03;
constexpr std::uint8_t in_endpoint = 0x84;

constexpr std::uint8_t bulk = LIBUSB_TRANSFER_TYPE_BULK;

std::vector<PretendInterface> interfaces_of(const PluggedIn& facts)
{
    if (facts.interfaces)
        return *facts.interfaces;
    std::vector<PretendInterface> all;
    if (facts.has_drive)
        all.push_back({.kind = LIBUSB_CLASS_MASS_STORAGE, .endpoints = {{0x81, bulk}, {0x02, bulk}}});
    if (facts.has_picoboot)
        all.push_back(
            {.kind = LIBUSB_CLASS_VENDOR_SPEC, .endpoints = {{out_endpoint, bulk}, {in_endpoint, bulk}}});
    return all;
}

/// Whether the interface that was claimed has the endpoint.
bool has_claimed(const libusb_device_handle& handle, std::uint8_t endpoint)
{
    const auto interfaces = interfaces_of(handle.device->facts);
    const auto claimed = static_cast<std::size_t>(handle.claimed);
    if (handle.claimed < 0 || claimed >= interfaces.size())
        return false;
    const auto& endpoints = interfaces[claimed].endpoints;
    return std::ranges::find(endpoints, endpoint, &std::pair<std::uint8_t, std::uint8_t>::first) !=
           endpoints.end();
}

bool is_in(std::uint8_t endpoint) { return (endpoint & LIBUSB_ENDPOINT_IN) != 0; }

/// The configuration of a device, with all that it points to.
struct Configuration {
    explicit Configuration(const PluggedIn& facts)
    {
        for (const PretendInterface& interface : interfaces_of(facts))
            add(interface);
        for (std::size_t at = 0; at < settings.size(); ++at)
            interfaces.push_back({&settings[at], has_setting[at] ? 1 : 0});
        descriptor.bNumInterfaces = static_cast<std::uint8_t>(interfaces.size());
        descriptor.interface = interfaces.data();
    }

    void add(const PretendInterface& interface)
    {
        auto& own = endpoints.emplace_back();
        for (const auto& [address, attributes] : interface.endpoints) {
            libusb_endpoint_descriptor& endpoint = own.emplace_back();
            endpoint.bEndpointAddress = address;
            endpoint.bmAttributes = attributes;
        }
        libusb_interface_descriptor setting{};
        setting.bInterfaceNumber = static_cast<std::uint8_t>(settings.size());
        setting.bInterfaceClass = interface.kind;
        setting.bNumEndpoints = static_cast<std::uint8_t>(own.size());
        setting.endpoint = own.data();
        settings.push_back(setting);
        has_setting.push_back(interface.has_setting);
    }

    libusb_config_descriptor descriptor{};
    std::deque<std::vector<libusb_endpoint_descriptor>> endpoints;
    std::vector<libusb_interface_descriptor> settings;
    std::vector<bool> has_setting;
    std::vector<libusb_interface> interfaces;
};

/// What the action returns, or the error that it throws.
int result_of(const auto& action)
{
    try {
        return static_cast<int>(action());
    } catch (const UsbStall&) {
        return LIBUSB_ERROR_PIPE;
    } catch (const Failure& failure) {
        return failure.status() == ExitStatus::timed_out ? LIBUSB_ERROR_TIMEOUT : LIBUSB_ERROR_NO_DEVICE;
    }
}

std::span<std::byte> bytes_at(unsigned char* data, std::size_t count)
{
    return {reinterpret_cast<std::byte*>(data), count};
}

int transferred(bool is_in, std::span<std::byte> bytes, const std::function<int()>& by_rom)
{
    return changed_transfer ? changed_transfer(is_in, bytes, by_rom) : by_rom();
}

int status_of_endpoint(const BootRom& rom, std::uint16_t endpoint, unsigned char* data)
{
    data[0] = rom.is_halted(endpoint == in_endpoint) ? 1 : 0;
    data[1] = 0;
    return 2;
}

}

extern "C" {

int libusb_init(libusb_context** context)
{
    *context = new libusb_context{plugged_in};
    ++libusb_things_in_use;
    return LIBUSB_SUCCESS;
}

void libusb_exit(libusb_context* context)
{
    delete context;
    --libusb_things_in_use;
}

ssize_t libusb_get_device_list(libusb_context* context, libusb_device*** list)
{
    const std::size_t count = context->seen.size();
    *list = new libusb_device* [count + 1] {};
    for (std::size_t at = 0; at < count; ++at)
        (*list)[at] = new libusb_device{context->seen[at]};
    libusb_things_in_use += static_cast<int>(count) + 1;
    return static_cast<ssize_t>(count);
}

libusb_device* libusb_ref_device(libusb_device* device)
{
    ++device->users;
    return device;
}

void libusb_unref_device(libusb_device* device)
{
    if (--device->users > 0)
        return;
    delete device;
    --libusb_things_in_use;
}

void libusb_free_device_list(libusb_device** list, int unref_devices)
{
    for (libusb_device** device = list; unref_devices != 0 && *device != nullptr; ++device)
        libusb_unref_device(*device);
    delete[] list;
    --libusb_things_in_use;
}

int libusb_get_device_descriptor(libusb_device* device, libusb_device_descriptor* descriptor)
{
    descriptor->idVendor = device->facts.vendor;
    descriptor->idProduct = device->facts.product;
    return LIBUSB_SUCCESS;
}

std::uint8_t libusb_get_bus_number(libusb_device* device) { return device->facts.bus; }
std::uint8_t libusb_get_device_address(libusb_device* device) { return device->facts.address; }

int libusb_get_port_numbers(libusb_device* device, std::uint8_t* ports, int room)
{
    const auto& all = device->facts.ports;
    if (static_cast<int>(all.size()) > room)
        return LIBUSB_ERROR_OVERFLOW;
    std::ranges::copy(all, ports);
    return static_cast<int>(all.size());
}

int libusb_get_active_config_descriptor(libusb_device* device, libusb_config_descriptor** config)
{
    if (device->facts.configuration_error != 0)
        return device->facts.configuration_error;
    auto* const configuration = new Configuration{device->facts};
    ++libusb_things_in_use;
    *config = &configuration->descriptor;
    return LIBUSB_SUCCESS;
}

void libusb_free_config_descriptor(libusb_config_descriptor* config)
{
    delete reinterpret_cast<Configuration*>(config); // its first member
    --libusb_things_in_use;
}

int libusb_open(libusb_device* device, libusb_device_handle** handle)
{
    if (device->facts.open_error != 0)
        return device->facts.open_error;
    *handle = new libusb_device_handle{libusb_ref_device(device)};
    ++libusb_things_in_use;
    return LIBUSB_SUCCESS;
}

void libusb_close(libusb_device_handle* handle)
{
    libusb_unref_device(handle->device);
    delete handle;
    --libusb_things_in_use;
}

int libusb_claim_interface(libusb_device_handle* handle, int interface)
{
    if (handle->device->facts.claim_error != 0)
        return handle->device->facts.claim_error;
    handle->claimed = interface;
    ++libusb_things_in_use;
    return LIBUSB_SUCCESS;
}

int libusb_release_interface(libusb_device_handle* handle, int interface)
{
    if (std::exchange(handle->claimed, -1) != interface)
        return LIBUSB_ERROR_NOT_FOUND;
    --libusb_things_in_use;
    return LIBUSB_SUCCESS;
}

int libusb_clear_halt(libusb_device_handle* handle, unsigned char endpoint)
{
    return transferred(false, {}, [&] {
        return result_of([&] { return handle->device->facts.rom->clear_halt(endpoint == in_endpoint), 0; });
    });
}

int libusb_control_transfer(libusb_device_handle* handle, std::uint8_t type, std::uint8_t request,
                            std::uint16_t, std::uint16_t index, unsigned char* data, std::uint16_t length,
                            unsigned)
{
    BootRom* const rom = handle->device->facts.rom;
    const auto bytes = bytes_at(data, length);
    if (type == 0x82 && request == LIBUSB_REQUEST_GET_STATUS && length == 2)
        return transferred(true, bytes, [&] { return status_of_endpoint(*rom, index, data); });
    if (handle->claimed != index)
        return LIBUSB_ERROR_PIPE;
    return transferred(is_in(type), bytes, [&]() -> int {
        if (type == 0x41)
            return result_of([&] { return rom->control_write(request), 0; });
        return type == 0xC1 ? result_of([&] { return rom->ask(request, bytes); }) : LIBUSB_ERROR_PIPE;
    });
}

int libusb_bulk_transfer(libusb_device_handle* handle, unsigned char endpoint, unsigned char* data,
                         int length, int* count, unsigned)
{
    if (!has_claimed(*handle, endpoint))
        return LIBUSB_ERROR_NOT_FOUND;
    if (handle->device->facts.transfer_error != 0)
        return handle->device->facts.transfer_error;
    BootRom* const rom = handle->device->facts.rom;
    const auto bytes = bytes_at(data, static_cast<std::size_t>(length));
    const int result = transferred(is_in(endpoint), bytes, [&] {
        return result_of([&]() -> std::size_t {
            if (is_in(endpoint))
                return rom->receive(bytes);
            rom->send(bytes);
            return bytes.size();
        });
    });
    *count = std::max(result, 0);
    return std::min(result, 0);
}

const char* libusb_strerror(int) { return "it is said so"; }
}
