#include "host/flash/boot_board.hpp"
#include "host/program/failure.hpp"
#include "tests/bytes.hpp"
#include "tests/host/flash/pretend_libusb.hpp"

#include <doctest/doctest.h>

#include <array>
#include <libusb-1.0/libusb.h>
#include <string>
#include <utility>
#include <vector>

namespace kfast::test {
namespace {

/// A Pico whose boot loader waits, and all that libusb has given out given back in the end.
struct Fixture {
    Fixture()
    {
        plugged_in.assign(1, {});
        plugged_in[0].rom = &rom;
    }
    ~Fixture() { CHECK(libusb_things_in_use == 0); }

    std::string failure_of_opening(const BootBoard& board, ExitStatus status)
    {
        try {
            open_boot_loader(board);
        } catch (const Failure& failure) {
            CHECK(failure.status() == status);
            return failure.what();
        }
        FAIL("it was opened");
        return {};
    }

    NorFlash memory{2};
    BootRom rom{memory};
    const BootBoard pico{BootChip::rp2040, "1-2.3"};
};

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

}

TEST_CASE_FIXTURE(Fixture, "boards in their boot loader are found by their numbers, in the order of ports")
{
    plugged_in.push_back({.product = 0x000a});                   // one that runs
    plugged_in.push_back({.vendor = 0x1209, .product = 0x0003}); // another device
    plugged_in.push_back({.product = 0x000f, .ports = {1}, .open_error = LIBUSB_ERROR_ACCESS});
    CHECK(boards_in_boot_loader() == std::vector<BootBoard>{{BootChip::rp2350, "1-1"}, pico});
    plugged_in.clear();
    CHECK(boards_in_boot_loader().empty());
}

TEST_CASE_FIXTURE(Fixture, "a board that is plugged in later is seen by the next look")
{
    const auto later = std::exchange(plugged_in, {});
    CHECK(boards_in_boot_loader().empty());
    plugged_in = later;
    CHECK(boards_in_boot_loader().size() == 1);
}

TEST_CASE_FIXTURE(Fixture, "a boot loader is opened with its drive and without")
{
    for (const bool has_drive : {true, false}) {
        plugged_in[0].has_drive = has_drive;
        const auto boot_loader = open_boot_loader(pico);
        const std::vector<std::byte> page(256, std::byte{0x12});
        std::vector<std::byte> found(256);
        boot_loader->erase(NorFlash::begin, 4096);
        boot_loader->write(NorFlash::begin, page);
        boot_loader->read(NorFlash::begin, found);
        CHECK(found == page);
        boot_loader->restart();
        CHECK(rom.restart);
    }
}

TEST_CASE_FIXTURE(Fixture, "endpoints that another program has left halted are freed")
{
    rom.send(bytes({1}));
    REQUIRE(rom.is_halted(true));
    open_boot_loader(pico)->restart();
    CHECK(rom.restart);
}

TEST_CASE_FIXTURE(Fixture, "who may not open it is told the rule and the command")
{
    plugged_in[0].open_error = LIBUSB_ERROR_ACCESS;
    const std::string text = failure_of_opening(pico, ExitStatus::no_permission);
    CHECK(has(text, "/dev/bus/usb/001/005"));
    CHECK(has(text, "install-udev\n"));
    CHECK(has(text, "SUBSYSTEM==\"usb\", ATTR{idVendor}==\"2e8a\", ATTR{idProduct}==\"0003\""));
}

TEST_CASE_FIXTURE(Fixture, "what keeps a boot loader from being opened is told")
{
    CHECK(has(failure_of_opening({BootChip::rp2350, "1-1"}, ExitStatus::wrong_chip), "RP2350"));
    CHECK(has(failure_of_opening({BootChip::rp2040, "1-9"}, ExitStatus::no_device), "port 1-9 is gone"));
    plugged_in[0].open_error = LIBUSB_ERROR_NO_DEVICE;
    CHECK(has(failure_of_opening(pico, ExitStatus::unplugged), "is gone"));
    plugged_in[0].open_error = 0;
    plugged_in[0].claim_error = LIBUSB_ERROR_BUSY;
    CHECK(has(failure_of_opening(pico, ExitStatus::refused), "another program"));
    plugged_in[0].claim_error = 0;
    plugged_in[0].has_picoboot = false;
    CHECK(has(failure_of_opening(pico, ExitStatus::refused), "without PICOBOOT"));
    CHECK_THROWS_AS(open_boot_loader(pico), NoPicoboot);
}

TEST_CASE_FIXTURE(Fixture, "what can go wrong with a transfer is told")
{
    const auto failure_with = [this](int error, ExitStatus status) {
        plugged_in[0].transfer_error = error;
        return failure_of_opening(pico, status);
    };
    CHECK(has(failure_with(LIBUSB_ERROR_TIMEOUT, ExitStatus::timed_out), "does not answer"));
    CHECK(has(failure_with(LIBUSB_ERROR_NO_DEVICE, ExitStatus::unplugged), "is gone"));
    CHECK(has(failure_with(LIBUSB_ERROR_IO, ExitStatus::unplugged), "is gone"));
    CHECK(has(failure_with(LIBUSB_ERROR_NO_MEM, ExitStatus::refused), "USB fails: it is said so"));
    CHECK(has(failure_with(LIBUSB_ERROR_PIPE, ExitStatus::refused), "refuses to let others wait"));
}

}
