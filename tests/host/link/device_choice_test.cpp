#include "host/link/device_address.hpp"
#include "host/program/failure.hpp"

#include <doctest/doctest.h>

#include <cstdlib>

namespace kfast::test {

namespace {

using Names = std::vector<std::string>;
using Addresses = std::vector<DeviceAddress>;

DeviceAddress usb(const std::string& serial) { return {DeviceAddress::Way::usb, "/dev/" + serial, serial}; }

std::string chosen(const Names& names, const Addresses& attached)
{
    std::string list;
    for (const DeviceAddress& address : chosen_addresses(names, attached))
        list += name_of(address) + ' ';
    return list;
}

void check_refusal(const Names& names, const Addresses& attached, ExitStatus status, const std::string& says)
{
    try {
        chosen_addresses(names, attached);
        FAIL("must be refused");
    } catch (const Failure& failure) {
        CHECK(failure.status() == status);
        CHECK(std::string{failure.what()}.find(says) != std::string::npos);
    }
}

}

TEST_CASE("the only device needs no name")
{
    CHECK(chosen({}, {usb("A")}) == "A ");
    check_refusal({}, {}, ExitStatus::no_device, "no device is attached");
    check_refusal({}, {usb("A"), usb("B")}, ExitStatus::wrong_usage, "A, B");
}

TEST_CASE("devices are chosen by serial number, or all of them, each once")
{
    const Addresses attached{usb("A"), usb("B"), usb("C")};
    CHECK(chosen({"B"}, attached) == "B ");
    CHECK(chosen({"C", "A", "C"}, attached) == "C A ");
    CHECK(chosen({"B", "all"}, attached) == "B A C ");
    check_refusal({"D"}, attached, ExitStatus::no_device, "attached: A, B, C");
    check_refusal({"D"}, {}, ExitStatus::no_device, "none is attached");
    check_refusal({"all"}, {}, ExitStatus::no_device, "no device is attached");
}

TEST_CASE("simulated devices are sockets")
{
    CHECK(chosen({"sim:/a", "sim:/b", "sim:/a"}, {}) == "/a /b ");
    CHECK(chosen({"sim"}, {usb("A")}) == sim_socket_path() + ' ');
    CHECK(chosen({"A", "sim:/dev/A"}, {usb("A")}) == "A /dev/A "); // a socket, whatever its path
}

TEST_CASE("a simulated device listens where the user's own sockets are")
{
    const char* const before = std::getenv("XDG_RUNTIME_DIR");
    const std::string kept = before == nullptr ? "" : before;
    ::setenv("XDG_RUNTIME_DIR", "/run/user/7", 1);
    CHECK(sim_socket_path() == "/run/user/7/kfast-sim.sock");
    const std::string otherwise = "/tmp/kfast-" + std::to_string(::getuid()) + "-sim.sock";
    ::setenv("XDG_RUNTIME_DIR", "", 1);
    CHECK(sim_socket_path() == otherwise);
    ::unsetenv("XDG_RUNTIME_DIR");
    CHECK(sim_socket_path() == otherwise);
    if (before != nullptr)
        ::setenv("XDG_RUNTIME_DIR", kept.c_str(), 1);
}

}
