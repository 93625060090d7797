#include "boards/pico/usb/usb_reports.hpp"

#include "boards/pico/chip/flash.hpp"
#include "boards/pico/usb/usb_controller.hpp"
#include "firmware/usb/hid_device.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace kfast::pico {
namespace {

using SerialNumber = std::array<char, 2 * flash::unique_id_bytes>;

constinit usb::HidDevice<UsbController> device;
constinit SerialNumber chip_number;

SerialNumber in_hexadecimal(const flash::UniqueId& id)
{
    constexpr std::string_view digits = "0123456789ABCDEF";
    SerialNumber text;
    for (std::size_t i = 0; i < id.size(); ++i) {
        text[2 * i] = digits[std::to_integer<std::size_t>(id[i] >> 4)];
        text[2 * i + 1] = digits[std::to_integer<std::size_t>(id[i] & std::byte{15})];
    }
    return text;
}

}

void UsbReports::begin() const
{
    chip_number = in_hexadecimal(flash::unique_id());
    device.begin({"KFAST", "KFAST Pico", serial_number()});
    device.controller().begin();
}

std::string_view UsbReports::serial_number() const { return {chip_number.data(), chip_number.size()}; }

std::optional<Report> UsbReports::take() const { return device.take(); }

bool UsbReports::send(const Report& report) const { return device.send(report); }

bool UsbReports::is_connected() const { return device.is_connected(); }

std::uint32_t UsbReports::connections() const { return device.connections(); }

extern "C" void usb_handler() { device.controller().dispatch_events(device); }

}
