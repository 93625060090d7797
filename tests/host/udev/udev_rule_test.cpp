#include "host/udev/udev.hpp"

#include "firmware/usb/usb_id.hpp"
#include "host/flash/boot_usb_id.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdio>
#include <string>

namespace kfast::test {
namespace {

std::string rule_for(const char* subsystem, const char* attribute, unsigned vendor, unsigned product)
{
    std::array<char, 200> rule{};
    std::snprintf(rule.data(), rule.size(),
                  "\nSUBSYSTEM==\"%s\", %s{idVendor}==\"%04x\", %s{idProduct}==\"%04x\", MODE=\"0660\", "
                  "GROUP=\"plugdev\", TAG+=\"uaccess\"\n",
                  subsystem, attribute, vendor, attribute, product);
    return rule.data();
}

bool has(std::string_view text, const std::string& part) { return text.find(part) != std::string_view::npos; }

}

TEST_CASE("the rules of udev are for the numbers of the firmware and of the boot loaders")
{
    CHECK(has(udev_rule, rule_for("hidraw", "ATTRS", usb::vendor_id, usb::product_id)));
    CHECK(has(udev_rule, rule_for("usb", "ATTR", boot_usb::vendor_id, boot_usb::rp2040_id)));
    CHECK(has(udev_rule, rule_for("usb", "ATTR", boot_usb::vendor_id, boot_usb::rp2350_id)));
    CHECK(udev_rule.ends_with("\n"));
}

TEST_CASE("who may not open a device is told the command and the line")
{
    const Failure failure = not_allowed("/dev/bus/usb/001/002", "\"0003\"");
    CHECK(failure.status() == ExitStatus::no_permission);
    const std::string text = failure.what();
    CHECK(has(text, "/dev/bus/usb/001/002"));
    CHECK(has(text, "sudo /"));
    CHECK(has(text, "udev_test install-udev\n"));
    std::string line = rule_for("usb", "ATTR", boot_usb::vendor_id, boot_usb::rp2040_id);
    line.erase(0, 1);
    CHECK(has(text, "  " + line));
    CHECK_FALSE(has(text, "hidraw"));
}

}
