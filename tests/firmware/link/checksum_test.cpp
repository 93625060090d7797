#include "core/bytes/crc16.hpp"
#include "firmware/link/checksum.hpp"
#include "tests/bytes.hpp"
#include "tests/firmware/link/link_bench.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <span>

/// The checksum of requests that change what a device keeps, or that are dangerous (docs/link.md).
namespace kfast::test {

using namespace link;

namespace {

constexpr std::uint8_t upload_tag = 42;

/// The checksum with which a message is sent.
template <class M>
int checksum_of(const M& message, std::uint8_t tag)
{
    const Report report = with_checksum(report_of(message, tag));
    CHECK(is_whole(report));
    return std::to_integer<int>(report.bytes[62]) | std::to_integer<int>(report.bytes[63]) << 8;
}

/// A laser, a scene in slot 1, which is chosen, and another one that is being sent to slot 2.
struct BusyBench : LinkBench {
    BusyBench()
    {
        device.now.arming = Arming::disarmed;
        REQUIRE(upload(begin_for_slot(1, "kept", kept), kept, 1).is_ok());
        REQUIRE(does(ChooseSlot{.slot = 1}));
        ask<Begun>(begin_for_slot(2, "new", scene), upload_tag);
        send_blocks(scene, upload_tag);
        while (link.next_report())
            continue;
    }

    /// Everything is as it was, and the upload goes on.
    void check_untouched()
    {
        const SlotState state = state_of(Store{flash, small_places});
        CHECK(state.chosen == 1);
        CHECK(state.slots[1].scene == kept);
        CHECK(state.slots[2].scene.empty());
        CHECK(device.now.arming == Arming::disarmed);
        CHECK_FALSE(device.is_in_boot_loader);
        ask<Done<Kind::commit>>(Commit{}, upload_tag);
        CHECK(state_of(Store{flash, small_places}).slots[2].scene == scene);
    }

    Scene kept = padded_scene(1000, 1);
    Scene scene = padded_scene(1200, 2);
};

/// Sends the request with each of its bits wrong, one after another, but for its kind.
template <class M>
void send_damaged(LinkBench& bench, const M& message)
{
    for (std::size_t bit = 8; bit < 8 * report_bytes; ++bit) {
        CAPTURE(bit);
        Report report = with_checksum(report_of(message, upload_tag));
        report.bytes[bit / 8] ^= static_cast<std::byte>(1 << bit % 8);
        bench.link.take(report.bytes, bench.now);
        const auto failure = bench.fetch<Failure>(report.tag());
        CHECK(failure.request == static_cast<std::uint8_t>(M::kind));
        CHECK(failure.status == Status::bad_report);
    }
}

}

TEST_CASE("the CRC-16 is that of the catalogues")
{
    CHECK(crc16(bytes({'1', '2', '3', '4', '5', '6', '7', '8', '9'})) == 0x29B1);
    CHECK(crc16({}) == 0xFFFF);
}

TEST_CASE("the checksum is that of the 62 bytes before it")
{
    CHECK(checksum_of(Commit{}, 0x5A) == 0x78B4);
    CHECK(checksum_of(EraseSlot{.slot = 1}, 0x5A) == 0x08D7);
    CHECK(
        checksum_of(Begin{.home = Home::ram, .slot = 255, .size = 0x010203, .crc = 0xA1B2C3D4, .name = {"n"}},
                    0x5A) == 0x8FCB);
}

TEST_CASE("what steers and what asks has none")
{
    CHECK(checksum_of(Pause{}, 1) == 0);
    CHECK(checksum_of(Disarm{}, 1) == 0);
    CHECK(checksum_of(Hello{}, 1) == 0);
}

TEST_CASE("a report is not whole when a bit of it is wrong")
{
    for (std::size_t bit = 0; bit < 8 * report_bytes; ++bit) {
        CAPTURE(bit);
        Report report = with_checksum(report_of(SlotContents{.slot = 1, .size = 500}, 7));
        REQUIRE(is_whole(report));
        report.bytes[bit / 8] ^= static_cast<std::byte>(1 << bit % 8);
        const bool is_of_another_kind = bit < 8 && !has_checksum(static_cast<Kind>(report.kind() & 0x7F));
        CHECK(is_whole(report) == is_of_another_kind);
    }
    Report acknowledgement = report_of(Acknowledgement{.next = 3, .window = 64}, 7);
    acknowledgement.bytes[0] = static_cast<std::byte>(code_of<Done<Kind::commit>>());
    CHECK_FALSE(is_whole(acknowledgement));
}

TEST_CASE("a request that would change what a device keeps does nothing when a bit of it is wrong")
{
    BusyBench bench;
    send_damaged(bench, LinkBench::begin_for_slot(1, "new", bench.scene));
    send_damaged(bench, Commit{});
    send_damaged(bench, Cancel{});
    send_damaged(bench, AskSlot{.slot = 1});
    send_damaged(bench, EraseSlot{.slot = 1});
    send_damaged(bench, ChooseSlot{.slot = 2});
    send_damaged(bench, Play{.home = Home::ram});
    send_damaged(bench, Silence{.milliseconds = 500});
    send_damaged(bench, Arm{});
    send_damaged(bench, EnterBootLoader{});
    CHECK(bench.link_errors() == 10 * 8 * (report_bytes - 1));
    bench.check_untouched();
}

}
