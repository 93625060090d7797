#include "host/link/hid_pipe.hpp"

#include "firmware/usb/usb_id.hpp"
#include "host/link/report_pipe.hpp"
#include "host/text/characters.hpp"
#include "host/udev/udev.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <hidapi.h>
#include <string>
#include <unistd.h>

namespace kfast {
namespace {

/// As in the report descriptor of the firmware.
constexpr unsigned short vendor_page = 0xFF00;

std::string utf8(const wchar_t* text)
{
    std::string bytes;
    for (; text != nullptr && *text != L'\0'; ++text)
        if (const auto value = static_cast<char32_t>(*text); is_scalar_value(value))
            append_utf8(bytes, value);
    return bytes;
}

/// 0: unknown.
bool is_ours(const hid_device_info& info) { return info.usage_page == vendor_page || info.usage_page == 0; }

class HidPipe final : public ReportPipe {
public:
    explicit HidPipe(hid_device* device) : device_{device} {}
    ~HidPipe() override { ::hid_close(device_); }

    void send(const Report& report) override
    {
        std::array<unsigned char, 1 + report_bytes> bytes{}; // 0 first: there are no report ids
        std::ranges::transform(report.bytes, bytes.begin() + 1,
                               [](std::byte byte) { return std::to_integer<unsigned char>(byte); });
        do {
            errno = 0;
            if (::hid_write(device_, bytes.data(), bytes.size()) >= 0)
                return;
        } while (errno == EINTR);
        throw errno == ETIMEDOUT ? takes_nothing() : unplugged();
    }

    std::optional<Report> receive(Milliseconds patience) override
    {
        std::array<unsigned char, report_bytes> bytes{};
        errno = 0;
        const int count =
            ::hid_read_timeout(device_, bytes.data(), bytes.size(), static_cast<int>(patience.count()));
        if (count < 0 && errno != EINTR)
            throw unplugged();
        if (count != static_cast<int>(bytes.size()))
            return std::nullopt;
        Report report;
        std::ranges::transform(bytes, report.bytes.begin(),
                               [](unsigned char byte) { return static_cast<std::byte>(byte); });
        return report;
    }

    Milliseconds now() const override { return steady_milliseconds(); }

private:
    hid_device* device_;
};

bool is_forbidden(const std::string& path)
{
    return ::access(path.c_str(), R_OK | W_OK) != 0 && (errno == EACCES || errno == EPERM);
}

}

std::vector<DeviceAddress> attached_devices()
{
    std::vector<DeviceAddress> devices;
    hid_device_info* const all = ::hid_enumerate(usb::vendor_id, usb::product_id);
    for (const hid_device_info* info = all; info != nullptr; info = info->next)
        if (is_ours(*info))
            devices.push_back({DeviceAddress::Way::usb, info->path, utf8(info->serial_number)});
    ::hid_free_enumeration(all);
    std::ranges::sort(devices, {}, &DeviceAddress::serial);
    return devices;
}

std::unique_ptr<ReportPipe> open_hid_pipe(const DeviceAddress& address)
{
    if (hid_device* const device = ::hid_open_path(address.path.c_str()))
        return std::make_unique<HidPipe>(device);
    const std::string reason = utf8(::hid_error(nullptr));
    if (is_forbidden(address.path))
        throw not_allowed(address.path, "hidraw");
    throw Failure{"cannot be opened at " + address.path + ": " + reason + ": unplug it and plug it in again",
                  ExitStatus::no_device};
}

}
