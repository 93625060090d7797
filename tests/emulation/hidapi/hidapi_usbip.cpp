// Takes the place of libhidapi-hidraw for tests: its devices are those that servers share over USB/IP at the
// addresses in KFAST_USBIP, HOST:PORT,HOST:PORT... A program finds it by LD_LIBRARY_PATH and is not changed
// for it.

#include "tests/emulation/hidapi/hid_description.hpp"
#include "tests/emulation/hidapi/usbip_attachment.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cwchar>
#include <hidapi.h>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

using namespace kfast::test;

struct hid_device_ {
    UsbIpAttachment attachment;
    HidDescription description;
    bool waits = true;
    std::wstring error = L"Success";
};

namespace {

constexpr int failed = -1;

thread_local std::wstring last_error = L"Success";

/// An entry of hidapi's list that keeps its texts.
struct Entry : hid_device_info {
    Entry(std::string where, HidDescription what)
        : hid_device_info{}, place{std::move(where)}, description{std::move(what)}
    {
        path = place.data();
        vendor_id = description.vendor;
        product_id = description.product;
        serial_number = description.serial_number.data();
        release_number = description.release;
        manufacturer_string = description.manufacturer.data();
        product_string = description.name.data();
        usage_page = description.usage_page;
        usage = description.usage;
        interface_number = description.interface;
        bus_type = HID_API_BUS_USB;
    }

    std::string place;
    HidDescription description;
};

std::unique_ptr<hid_device_> open_at(const std::string& address)
{
    auto attachment = UsbIpAttachment::attach(address);
    if (!attachment)
        return nullptr;
    auto description = describe(*attachment);
    if (!description)
        return nullptr;
    return std::unique_ptr<hid_device_>{new hid_device_{std::move(*attachment), std::move(*description)}};
}

bool fits(unsigned short wanted, unsigned short number) { return wanted == 0 || wanted == number; }

int fail(hid_device& device, const wchar_t* why, int number)
{
    device.error = why;
    errno = number;
    return failed;
}

int give(const std::wstring& text, wchar_t* to, std::size_t room)
{
    if (room == 0)
        return failed;
    to[text.copy(to, room - 1)] = L'\0';
    return 0;
}

int give_report(hid_device& device, unsigned char* to, std::size_t room)
{
    const Bytes report = std::move(device.attachment.received().front());
    device.attachment.received().pop_front();
    const auto count = std::min(room, report.size());
    std::copy_n(report.begin(), count, to);
    return static_cast<int>(count);
}

/// What is left until `end`, if there is one.
Milliseconds left_until(std::optional<std::chrono::steady_clock::time_point> end)
{
    if (!end)
        return Milliseconds{-1};
    return std::max(std::chrono::ceil<Milliseconds>(*end - std::chrono::steady_clock::now()),
                    Milliseconds{0});
}

}

extern "C" {

int hid_init() { return 0; }

int hid_exit() { return 0; }

hid_device_info* hid_enumerate(unsigned short vendor, unsigned short product)
{
    hid_device_info* first = nullptr;
    hid_device_info** end = &first;
    const char* const addresses = std::getenv("KFAST_USBIP");
    std::istringstream list{addresses == nullptr ? "" : addresses};
    for (std::string address; std::getline(list, address, ',');) {
        auto device = open_at(address);
        if (!device || !fits(vendor, device->description.vendor) ||
            !fits(product, device->description.product))
            continue;
        *end = new Entry{address, std::move(device->description)};
        end = &(*end)->next;
    }
    return first;
}

void hid_free_enumeration(hid_device_info* first)
{
    while (first != nullptr)
        delete static_cast<Entry*>(std::exchange(first, first->next));
}

hid_device* hid_open_path(const char* path)
{
    auto device = open_at(path);
    if (!device) {
        last_error = L"Failed to open a device with path: nothing is shared there";
        return nullptr;
    }
    device->attachment.listen(device->description.input, device->description.input_bytes);
    return device.release();
}

hid_device* hid_open(unsigned short vendor, unsigned short product, const wchar_t* serial_number)
{
    hid_device_info* const all = hid_enumerate(vendor, product);
    hid_device* device = nullptr;
    last_error = L"Device with requested VID/PID/(SerialNumber) not found";
    for (const hid_device_info* info = all; info != nullptr && device == nullptr; info = info->next)
        if (serial_number == nullptr || std::wcscmp(serial_number, info->serial_number) == 0)
            device = hid_open_path(info->path);
    hid_free_enumeration(all);
    return device;
}

void hid_close(hid_device* device) { delete device; }

int hid_write(hid_device* device, const unsigned char* data, std::size_t length)
{
    if (length == 0)
        return fail(*device, L"Zero buffer/length", EINVAL);
    const Bytes report(data + (data[0] == 0 ? 1 : 0),
                       data + length); // without its number, when there are none
    if (!device->attachment.send(device->description.output, report))
        return fail(*device, errno == ETIMEDOUT ? L"Connection timed out" : L"No such device", errno);
    return static_cast<int>(length);
}

int hid_read_timeout(hid_device* device, unsigned char* data, std::size_t length, int milliseconds)
{
    using Clock = std::chrono::steady_clock;
    std::optional<Clock::time_point> end;
    if (milliseconds >= 0)
        end = Clock::now() + Milliseconds{milliseconds};
    UsbIpAttachment& attachment = device->attachment;
    while (attachment.received().empty()) {
        const auto event = attachment.wait(left_until(end));
        if (event == UsbIpAttachment::Event::gone)
            return fail(*device, L"device disconnected", ENODEV);
        if (event == UsbIpAttachment::Event::interrupted)
            return fail(*device, L"Interrupted system call", EINTR);
        if (event == UsbIpAttachment::Event::silence)
            return 0;
    }
    return give_report(*device, data, length);
}

int hid_read(hid_device* device, unsigned char* data, std::size_t length)
{
    return hid_read_timeout(device, data, length, device->waits ? -1 : 0);
}

int hid_set_nonblocking(hid_device* device, int nonblocking)
{
    device->waits = nonblocking == 0;
    return 0;
}

int hid_get_manufacturer_string(hid_device* device, wchar_t* text, std::size_t room)
{
    return give(device->description.manufacturer, text, room);
}

int hid_get_product_string(hid_device* device, wchar_t* text, std::size_t room)
{
    return give(device->description.name, text, room);
}

int hid_get_serial_number_string(hid_device* device, wchar_t* text, std::size_t room)
{
    return give(device->description.serial_number, text, room);
}

const wchar_t* hid_error(hid_device* device)
{
    return device == nullptr ? last_error.c_str() : device->error.c_str();
}

const hid_api_version* hid_version()
{
    static constexpr hid_api_version version{HID_API_VERSION_MAJOR, HID_API_VERSION_MINOR,
                                             HID_API_VERSION_PATCH};
    return &version;
}

const char* hid_version_str() { return HID_API_VERSION_STR; }
}
