#include "firmware/usb/usb_id.hpp"
#include "host/link/udev_rule.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdio>
#include <string>

namespace kfast::test {

TEST_CASE("the rule of udev is for the numbers of the firmware")
{
    std::array<char, 80> numbers{};
    std::snprintf(numbers.data(), numbers.size(), "ATTRS{idVendor}==\"%04x\", ATTRS{idProduct}==\"%04x\"",
                  unsigned{usb::vendor_id}, unsigned{usb::product_id});
    CHECK(udev_rule.find(numbers.data()) != std::string_view::npos);
    CHECK(udev_rule.ends_with("\n"));
}

}
