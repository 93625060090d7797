// A program that uses hidapi as it is installed, to try what lies behind it: the image
// tests/boards/pico/usb_trial.cpp, which sends every report back with one added to its first byte.
//
//     hid-trial list               the devices: vendor:product, usage page, texts
//     hid-trial exchange COUNT     reports go there and back; several are on their way
//     hid-trial silence MS         nothing comes for so long
//     hid-trial stuck              reports are sent until the device takes none for too long
//     hid-trial unplugged          reports go there and back until the device is unplugged
//
// Exits with 0 if all is as it should be; if not, it says what is not.

#include "firmware/usb/usb_id.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <hidapi.h>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace {

using Report = std::array<unsigned char, 64>;
using Device = std::unique_ptr<hid_device, decltype(&hid_close)>;

constexpr int patience = 60000; // milliseconds

struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

void expect(bool condition, const std::string& message)
{
    if (!condition)
        throw Failure{message};
}

std::string narrow(const wchar_t* text)
{
    std::string result;
    for (; text != nullptr && *text != L'\0'; ++text)
        result += static_cast<char>(*text);
    return result;
}

Report report(unsigned seed)
{
    Report bytes;
    for (unsigned i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<unsigned char>(seed * 31 + i);
    return bytes;
}

Device opened()
{
    Device device{hid_open(kfast::usb::vendor_id, kfast::usb::product_id, nullptr), &hid_close};
    expect(device != nullptr, "it cannot be opened: " + narrow(hid_error(nullptr)));
    return device;
}

bool is_sent(hid_device* device, unsigned seed)
{
    std::array<unsigned char, 65> bytes{};
    const Report sent = report(seed);
    std::ranges::copy(sent, bytes.begin() + 1);
    return hid_write(device, bytes.data(), bytes.size()) == static_cast<int>(bytes.size());
}

void expect_back(hid_device* device, unsigned seed)
{
    Report came{};
    const int count = hid_read_timeout(device, came.data(), came.size(), patience);
    Report wanted = report(seed);
    ++wanted[0];
    expect(count == static_cast<int>(came.size()), "report " + std::to_string(seed) +
                                                       " does not come back: " + std::to_string(count) +
                                                       ", " + narrow(hid_error(device)));
    expect(came == wanted, "report " + std::to_string(seed) + " comes back as another one");
}

void list()
{
    hid_device_info* const all = hid_enumerate(0, 0);
    for (const hid_device_info* info = all; info != nullptr; info = info->next)
        std::printf("%04x:%04x page %04x usage %u interface %d '%s' '%s' '%s'\n", info->vendor_id,
                    info->product_id, info->usage_page, info->usage, info->interface_number,
                    narrow(info->manufacturer_string).c_str(), narrow(info->product_string).c_str(),
                    narrow(info->serial_number).c_str());
    hid_free_enumeration(all);
}

void exchange(unsigned count)
{
    constexpr unsigned ahead = 8;
    const Device device = opened();
    unsigned sent = 0;
    for (unsigned received = 0; received < count; ++received) {
        for (; sent < count && sent < received + ahead; ++sent)
            expect(is_sent(device.get(), sent), "report " + std::to_string(sent) + " cannot be sent");
        expect_back(device.get(), received);
    }
    std::array<wchar_t, 64> number;
    expect(hid_get_serial_number_string(device.get(), number.data(), number.size()) == 0,
           "it has no serial number");
    std::printf("%u reports went there and back: %s\n", count, narrow(number.data()).c_str());
}

void silence(int milliseconds)
{
    using Clock = std::chrono::steady_clock;
    const Device device = opened();
    Report came;
    const auto begin = Clock::now();
    expect(hid_read_timeout(device.get(), came.data(), came.size(), milliseconds) == 0, "something comes");
    expect(Clock::now() - begin >= std::chrono::milliseconds{milliseconds}, "it does not wait");
    hid_set_nonblocking(device.get(), 1);
    expect(hid_read(device.get(), came.data(), came.size()) == 0, "something comes at once");
    expect(is_sent(device.get(), 1), "it cannot be sent to");
    expect_back(device.get(), 1);
}

void stuck()
{
    const Device device = opened();
    expect(is_sent(device.get(), 0), "it cannot be sent to");
    std::cout << "goes" << std::endl;
    while (is_sent(device.get(), 0))
        ;
    expect(errno == ETIMEDOUT, "it is not too late, but " + narrow(hid_error(device.get())));
    std::cout << "stuck: " << narrow(hid_error(device.get())) << '\n';
}

void unplugged()
{
    const Device device = opened();
    for (unsigned i = 0;; ++i) {
        Report came;
        if (!is_sent(device.get(), i) ||
            hid_read_timeout(device.get(), came.data(), came.size(), patience) < 0)
            break;
        if (i == 0)
            std::cout << "goes" << std::endl;
    }
    Report came;
    expect(hid_read_timeout(device.get(), came.data(), came.size(), patience) < 0, "it can still be read");
    expect(!is_sent(device.get(), 0), "it can still be sent to");
    expect(!narrow(hid_error(device.get())).empty(), "it does not say why");
    std::cout << "unplugged: " << narrow(hid_error(device.get())) << '\n';
}

int run(std::string_view command, int number)
{
    if (command == "list")
        list();
    else if (command == "exchange")
        exchange(static_cast<unsigned>(number));
    else if (command == "silence")
        silence(number);
    else if (command == "stuck")
        stuck();
    else if (command == "unplugged")
        unplugged();
    else
        return 2;
    return 0;
}

}

int main(int count, char** words)
{
    try {
        hid_init();
        const int status = run(count > 1 ? words[1] : "", count > 2 ? std::atoi(words[2]) : 0);
        hid_exit();
        return status;
    } catch (const Failure& failure) {
        std::cerr << "hid-trial: " << failure.what() << '\n';
        return 1;
    }
}
