#include "tests/bytes.hpp"
#include "tests/firmware/usb/pretended_computer.hpp"

#include <string>

namespace kfast::usb::test {
namespace {

using kfast::test::bytes;

constexpr unsigned device_descriptor_value = 0x0100;
constexpr unsigned configuration_value_asked = 0x0200;
constexpr std::size_t room = HidDevice<PretendedController>::room_from_computer;
constexpr std::size_t room_back = HidDevice<PretendedController>::room_to_computer;

std::string text_of(const Bytes& descriptor)
{
    std::string text;
    for (std::size_t i = 2; i < descriptor.size(); i += 2)
        text += static_cast<char>(descriptor[i]);
    return text;
}

int status_of(PretendedComputer& computer, unsigned endpoint)
{
    const auto status = computer.ask(0x8200, 0, endpoint, 2);
    if (!status)
        return -1;
    REQUIRE(status->size() == 2);
    REQUIRE((*status)[1] == std::byte{0});
    return std::to_integer<int>((*status)[0]);
}

}

TEST_CASE("the device says what it is")
{
    PretendedComputer computer;
    CHECK(computer.ask(0x8006, device_descriptor_value, 0, 18) ==
          bytes({18, 1, 0x00, 0x02, 0, 0, 0, 64, 0x09, 0x12, 0x01, 0x00, 0x00, 0x01, 1, 2, 3, 1}));
    CHECK(computer.ask(0x8006, configuration_value_asked, 0, 255) ==
          bytes({9, 2, 41, 0,    1,  1, 0, 0x80, 250,  9, 4,  0, 0, 2, 3, 0,    0, 0,  9, 0x21, 0x11,
                 1, 0, 1,  0x22, 25, 0, 7, 5,    0x81, 3, 64, 0, 1, 7, 5, 0x01, 3, 64, 0, 1}));
    const auto hid = computer.ask(0x8106, 0x2100, 0, 64);
    CHECK(hid == bytes({9, 0x21, 0x11, 1, 0, 1, 0x22, 25, 0}));
    const auto reports = computer.ask(0x8106, 0x2200, 0, 25);
    CHECK(reports == bytes({0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x75,
                            0x08, 0x95, 0x40, 0x09, 0x01, 0x81, 0x02, 0x09, 0x02, 0x91, 0x02, 0xC0}));
}

TEST_CASE("a descriptor is cut off where the computer has no more room")
{
    PretendedComputer computer;
    CHECK(computer.ask(0x8006, device_descriptor_value, 0, 8)->size() == 8);
    CHECK(computer.ask(0x8006, configuration_value_asked, 0, 9)->size() == 9);
    CHECK(computer.ask(0x8006, device_descriptor_value, 0, 0) ==
          Bytes{}); // there is nothing but the acknowledgement
}

TEST_CASE("it has names")
{
    PretendedComputer computer;
    CHECK(computer.ask(0x8006, 0x0300, 0, 255) == bytes({4, 3, 0x09, 0x04}));
    CHECK(text_of(*computer.ask(0x8006, 0x0301, 0x0409, 255)) == "Maker");
    CHECK(text_of(*computer.ask(0x8006, 0x0302, 0x0409, 255)) == "Product");
    CHECK(text_of(*computer.ask(0x8006, 0x0303, 0x0409, 255)) == "0123456789ABCDEF");
    CHECK_FALSE(computer.ask(0x8006, 0x0304, 0x0409, 255));
    CHECK_FALSE(computer.ask(0x8006, 0x03EE, 0, 255));
}

TEST_CASE("data that end with a full packet are ended by an empty one, if more was asked for")
{
    PretendedComputer computer;
    computer.device.begin({"Maker", "1234567890123456789012345678901 and more", "1"});
    const auto packets = [&](unsigned length) {
        computer.setup(0x8006, 0x0302, 0x0409, length);
        std::vector<std::size_t> sizes;
        while (const auto packet = computer.take_packet(Endpoint::control_in))
            sizes.push_back(packet->size());
        return sizes;
    };
    CHECK(packets(255) == std::vector<std::size_t>{64, 0});
    CHECK(packets(64) == std::vector<std::size_t>{64});
    CHECK(packets(63) == std::vector<std::size_t>{63});
}

TEST_CASE("what it does not know it refuses, and goes on")
{
    PretendedComputer computer;
    computer.configure();
    const auto refuses = [&](unsigned kind, unsigned value, unsigned index, unsigned length) {
        CAPTURE(kind);
        CAPTURE(value);
        const bool is_refused = !computer.ask(kind, value, index, length);
        CHECK(is_refused);
        CHECK(computer.controller.of(Endpoint::control_in).is_stalled == is_refused);
        CHECK(computer.controller.of(Endpoint::control_out).is_stalled == is_refused);
    };
    refuses(0x8006, 0x0600, 0, 10); // the qualifier of devices that can be faster
    refuses(0x8006, 0x0101, 0, 18); // a second device
    refuses(0x8006, 0x2200, 0, 25); // a report descriptor of the device
    refuses(0x8106, 0x0100, 0, 18); // a device descriptor of the interface
    refuses(0x8006, 0x2100, 0, 9);  // a HID descriptor of the device
    refuses(0x8106, 0x0200, 0, 41); // a configuration of the interface
    refuses(0x8106, 0x0301, 0, 64); // a string of the interface
    refuses(0x8106, 0x2200, 1, 25); // another interface
    refuses(0xC001, 0, 0, 4);       // of a vendor
    refuses(0xA103, 0, 0, 1);       // GET_PROTOCOL, for mice and keyboards
    refuses(0x0003, 1, 0, 0);       // remote wakeup
    refuses(0x0001, 1, 0, 0);
    refuses(0x0203, 0, 0x82, 0); // an endpoint that is not there
    refuses(0x0201, 1, 0x81, 0); // a feature that is not there
    refuses(0x8200, 0, 0x02, 2);
    refuses(0x010B, 1, 0, 0); // a second setting
    refuses(0x010B, 0, 1, 0);
    refuses(0x810A, 0, 1, 1);
    refuses(0x0009, 2, 0, 0);       // a second configuration
    refuses(0x0005, 3, 0, 0);       // an address while it works
    refuses(0xA101, 0x0101, 0, 64); // a report with a number
    refuses(0xA101, 0x0300, 0, 64); // a feature report
    refuses(0x210A, 0x0001, 0, 0);
    refuses(0xA102, 0x0001, 0, 1); // the idle rate of a report with a number
    CHECK(computer.ask(0x8008, 0, 0, 1) == bytes({1}));
}

TEST_CASE("the address counts when the transfer is over")
{
    PretendedComputer computer;
    computer.setup(0x0005, 42, 0, 0);
    CHECK(computer.controller.address == 0);
    CHECK(computer.take_packet(Endpoint::control_in) == Bytes{});
    CHECK(computer.controller.address == 42);
    CHECK_FALSE(computer.ask(0x0005, 128));
    computer.setup(0x0005, 7, 0, 0); // and is broken off
    computer.configure();
    CHECK(computer.controller.address == 42);
}

TEST_CASE("it is configured, and no more after a reset")
{
    PretendedComputer computer;
    auto& device = computer.device;
    CHECK_FALSE(device.is_connected());
    CHECK(computer.ask(0x8008, 0, 0, 1) == bytes({0}));
    CHECK_FALSE(computer.ask(0x8100, 0, 0, 2));
    CHECK(status_of(computer, 0x81) == -1);
    CHECK(status_of(computer, 0x00) == 0);
    CHECK(status_of(computer, 0x80) == 0);
    CHECK_FALSE(computer.ask(0x0203, 0, 0x81)); // there is nothing to be halted
    CHECK_FALSE(computer.ask(0xA102, 0, 0, 1));

    computer.configure();
    CHECK(device.is_connected());
    CHECK(device.connections() == 1);
    CHECK(computer.ask(0x8008, 0, 0, 1) == bytes({1}));
    CHECK(computer.ask(0x8000, 0, 0, 2) == bytes({0, 0}));
    CHECK(computer.ask(0x8100, 0, 0, 2) == bytes({0, 0}));
    CHECK(computer.ask(0x810A, 0, 0, 1) == bytes({0}));

    device.suspended();
    CHECK_FALSE(device.is_connected());
    device.resumed();
    CHECK(device.is_connected());

    computer.reset();
    CHECK_FALSE(device.is_connected());
    CHECK_FALSE(computer.put_packet(Endpoint::reports_out, packet(1)));
    computer.configure();
    CHECK(device.connections() == 2);
    CHECK(computer.ask(0x0009, 0));
    CHECK_FALSE(device.is_connected());
}

TEST_CASE("a computer from which something comes, or goes to, is awake")
{
    PretendedComputer computer;
    auto& device = computer.device;
    computer.configure();
    REQUIRE(device.send({}));
    device.suspended();
    REQUIRE(computer.take_packet(Endpoint::reports_in));
    CHECK(device.is_connected());
    device.suspended();
    REQUIRE(computer.put_packet(Endpoint::reports_out, packet(1)));
    CHECK(device.is_connected());
    device.suspended();
    CHECK(computer.ask(0x8008, 0, 0, 1) == bytes({1}));
    CHECK(device.is_connected());
}

TEST_CASE("the idle rate is kept for the computer")
{
    PretendedComputer computer;
    CHECK_FALSE(computer.ask(0x210A, 0x7D00));
    computer.configure();
    CHECK(computer.ask(0xA102, 0, 0, 1) == bytes({0}));
    CHECK(computer.ask(0x210A, 0x7D00));
    CHECK(computer.ask(0xA102, 0, 0, 1) == bytes({0x7D}));
    computer.configure();
    CHECK(computer.ask(0xA102, 0, 0, 1) == bytes({0}));
}

TEST_CASE("reports come in order, and wait when nobody takes them")
{
    PretendedComputer computer;
    computer.configure();
    int sent = 0;
    int taken = 0;
    while (computer.put_packet(Endpoint::reports_out, packet(sent)))
        ++sent;
    CHECK(sent == room);
    for (; taken < 100; ++taken) {
        REQUIRE(computer.device.take() == report(taken));
        REQUIRE(computer.put_packet(Endpoint::reports_out, packet(sent++)));
        REQUIRE_FALSE(computer.put_packet(Endpoint::reports_out, packet(-1)));
    }
    while (const auto found = computer.device.take())
        REQUIRE(found == report(taken++));
    CHECK(taken == sent);
}

TEST_CASE("a short report is filled up with zeros, also where a long one was")
{
    PretendedComputer computer;
    computer.configure();
    for (std::size_t i = 0; i < room; ++i) {
        REQUIRE(computer.put_packet(Endpoint::reports_out, packet(1)));
        REQUIRE(computer.device.take());
    }
    for (const std::size_t size : {0u, 1u, 63u}) {
        REQUIRE(computer.put_packet(Endpoint::reports_out, packet(2, size)));
        CHECK(computer.device.take() == report(2, size));
    }
}

TEST_CASE("a report by SET_REPORT comes like any other")
{
    PretendedComputer computer;
    CHECK_FALSE(computer.control_write(0x2109, 0x0200, 0, packet(1)));
    computer.configure();
    CHECK(computer.put_packet(Endpoint::reports_out, packet(1)));
    CHECK(computer.control_write(0x2109, 0x0200, 0, packet(2)));
    CHECK(computer.control_write(0x2109, 0x0200, 0, packet(3, 5)));
    CHECK(computer.put_packet(Endpoint::reports_out, packet(4)));
    CHECK(computer.device.take() == report(1));
    CHECK(computer.device.take() == report(2));
    CHECK(computer.device.take() == report(3, 5));
    CHECK(computer.device.take() == report(4));
    CHECK_FALSE(computer.device.take());
    CHECK_FALSE(computer.control_write(0x2109, 0x0100, 0, packet(5)));
    CHECK_FALSE(computer.control_write(0x2109, 0x0200, 0, packet(5, 65)));
    CHECK_FALSE(computer.ask(0x2109, 0x0200, 0, 0));
    CHECK_FALSE(computer.device.take());
}

TEST_CASE("SET_REPORT is refused when there is no room, and takes none of another report")
{
    PretendedComputer computer;
    computer.configure();
    for (std::size_t i = 0; i + 1 < room; ++i)
        REQUIRE(computer.put_packet(Endpoint::reports_out, packet(static_cast<int>(i))));
    CHECK_FALSE(computer.control_write(0x2109, 0x0200, 0, packet(-1)));
    CHECK(computer.put_packet(Endpoint::reports_out, packet(room - 1)));
    CHECK_FALSE(computer.control_write(0x2109, 0x0200, 0, packet(-1)));
    for (std::size_t i = 0; i < room; ++i)
        REQUIRE(computer.device.take() == report(static_cast<int>(i)));
    CHECK_FALSE(computer.device.take());
    CHECK(computer.control_write(0x2109, 0x0200, 0, packet(7)));
    CHECK(computer.device.take() == report(7));
}

TEST_CASE("reports go in order, as many as there is room for")
{
    PretendedComputer computer;
    auto& device = computer.device;
    CHECK_FALSE(device.send(report(0)));
    computer.configure();
    int sent = 0;
    while (device.send(report(sent)))
        ++sent;
    CHECK(sent == room_back);
    for (int i = 0; i < 20; ++i) {
        REQUIRE(computer.take_packet(Endpoint::reports_in) == packet(i));
        REQUIRE(device.send(report(sent++)));
    }
}

TEST_CASE("GET_REPORT gives what was sent last")
{
    PretendedComputer computer;
    computer.configure();
    CHECK(computer.ask(0xA101, 0x0100, 0, 64) == Bytes(64));
    computer.device.send(report(1));
    computer.device.send(report(2));
    CHECK(computer.ask(0xA101, 0x0100, 0, 64) == Bytes(64));
    computer.take_packet(Endpoint::reports_in);
    CHECK(computer.ask(0xA101, 0x0100, 0, 64) == packet(1));
    CHECK(computer.ask(0xA101, 0x0100, 0, 10)->size() == 10);
}

TEST_CASE("a halt stops one way alone, and loses no report")
{
    PretendedComputer computer;
    auto& device = computer.device;
    computer.configure();
    REQUIRE(computer.put_packet(Endpoint::reports_out, packet(1)));
    REQUIRE(device.send(report(2)));

    CHECK(computer.ask(0x0203, 0, 0x81));
    CHECK(status_of(computer, 0x81) == 1);
    CHECK(status_of(computer, 0x01) == 0);
    CHECK_FALSE(computer.take_packet(Endpoint::reports_in));
    CHECK(device.send(report(3)));
    CHECK(computer.put_packet(Endpoint::reports_out, packet(4)));
    CHECK(computer.ask(0x0201, 0, 0x81));
    CHECK(status_of(computer, 0x81) == 0);
    CHECK(computer.controller.of(Endpoint::reports_in).times_opened == 2);
    CHECK(computer.take_packet(Endpoint::reports_in) == packet(2));
    CHECK(computer.take_packet(Endpoint::reports_in) == packet(3));

    CHECK(computer.ask(0x0203, 0, 0x01));
    CHECK(status_of(computer, 0x01) == 1);
    CHECK_FALSE(computer.put_packet(Endpoint::reports_out, packet(5)));
    CHECK(device.take() == report(1));
    CHECK_FALSE(computer.put_packet(Endpoint::reports_out, packet(5)));
    CHECK(computer.ask(0x0201, 0, 0x01));
    CHECK(computer.controller.of(Endpoint::reports_out).times_opened == 2);
    CHECK(computer.put_packet(Endpoint::reports_out, packet(5)));
    CHECK(device.take() == report(4));
    CHECK(device.take() == report(5));
}

TEST_CASE("clearing a halt that is none begins the pipe anew, and loses no report")
{
    PretendedComputer computer;
    computer.configure();
    computer.device.send(report(1));
    CHECK(computer.ask(0x0201, 0, 0x81));
    CHECK(computer.controller.of(Endpoint::reports_in).times_opened == 2);
    CHECK(computer.take_packet(Endpoint::reports_in) == packet(1));
    CHECK(computer.ask(0x010B, 0, 0));
    CHECK(computer.controller.of(Endpoint::reports_in).times_opened == 3);
    CHECK(computer.controller.of(Endpoint::reports_out).times_opened == 2);
}

TEST_CASE("what an earlier computer sent, or did not fetch, is lost")
{
    PretendedComputer computer;
    for (const bool by_reset : {true, false}) {
        computer.configure();
        computer.put_packet(Endpoint::reports_out, packet(1));
        computer.device.send(report(2));
        if (by_reset)
            computer.reset();
        computer.configure();
        CHECK_FALSE(computer.device.take());
        CHECK_FALSE(computer.take_packet(Endpoint::reports_in));
        CHECK(computer.device.send(report(3)));
        CHECK(computer.take_packet(Endpoint::reports_in) == packet(3));
    }
}

TEST_CASE("a transfer that is broken off at any point does not harm the next one")
{
    PretendedComputer computer;
    computer.configure();
    const auto works = [&] { return computer.ask(0x8006, device_descriptor_value, 0, 18)->size() == 18; };
    computer.setup(0x8006, configuration_value_asked, 0, 255);
    CHECK(works());
    computer.setup(0x8006, configuration_value_asked, 0, 255);
    computer.take_packet(Endpoint::control_in); // and nobody says that it has come
    CHECK(works());
    computer.setup(0x2109, 0x0200, 0, 64);
    CHECK(works());
    computer.setup(0x2109, 0x0200, 0, 64);
    computer.put_packet(Endpoint::control_out, packet(1));
    CHECK(works());
    computer.setup(0x2109, 0x0200, 0, 64);
    computer.reset();
    CHECK(works());
    computer.configure();
    CHECK_FALSE(computer.device.take());
}

}
