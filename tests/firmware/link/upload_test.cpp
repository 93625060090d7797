#include "tests/firmware/link/link_bench.hpp"

#include <doctest/doctest.h>

/// Uploads over a link that loses nothing, or one thing that is named.
namespace kfast::test {

using namespace link;

namespace {

constexpr std::uint8_t tag = 42;

struct Upload {
    LinkBench bench;
    Scene scene = padded_scene(50 * 60 - 7, 1);
    Begin begin = LinkBench::begin_for_slot(0, "scene", scene);

    Upload() { REQUIRE(bench.ask<Begun>(begin, tag) == Begun{.next = 0, .window = 64}); }

    void blocks(std::size_t first, std::size_t count) { bench.send_blocks(scene, tag, first, count); }
    Acknowledgement acknowledgement() { return bench.fetch<Acknowledgement>(tag); }
    bool has_acknowledgement() { return bench.link.has_report(); }
    bool is_committed()
    {
        bench.ask<Done<Kind::commit>>(Commit{}, tag);
        return bench.slots.entry(0).size == scene.size() && std::ranges::equal(bench.slots.scene(0), scene);
    }
    StatusWithNumber commit_refused()
    {
        const auto failure = bench.ask<Failure>(Commit{}, tag);
        return {failure.status, failure.number};
    }
};

}

TEST_CASE("a beginning that the device puts off is answered when it can")
{
    LinkBench bench;
    const Scene scene = padded_scene(2000, 1);
    bench.device.puts_off = 2;
    bench.send(LinkBench::begin_for_ram(scene), tag);
    bench.wait(1);
    CHECK_FALSE(bench.link.has_report());
    bench.wait(1);
    CHECK(bench.fetch<Begun>(tag) == Begun{.next = 0, .window = 64});
    bench.send_blocks(scene, tag);
    bench.send(Commit{}, tag);
    CHECK(bench.last_failure().is_ok());
    CHECK(bench.does(Play{.home = Home::ram}));
}

TEST_CASE("a scene that lies in RAM no more comes whole once more")
{
    LinkBench bench;
    const Scene scene = padded_scene(2000, 1);
    const Begin begin = LinkBench::begin_for_ram(scene);
    bench.ask<Begun>(begin, tag);
    bench.send_blocks(scene, tag);
    bench.ask<Done<Kind::commit>>(Commit{}, tag);
    bench.device.leased = {};
    CHECK(bench.ask<Begun>(begin, tag) == Begun{.next = 0, .window = 64});
}

TEST_CASE("memory that is needed for something else ends the upload into it")
{
    LinkBench bench;
    const Scene scene = padded_scene(2000, 1);
    bench.ask<Begun>(LinkBench::begin_for_ram(scene), tag);
    bench.send_blocks(scene, tag, 0, 5);
    bench.device.leased = {};
    bench.device.ram.clear();
    bench.device.ram.shrink_to_fit(); // a byte that is written nevertheless is noticed
    bench.send_blocks(scene, tag, 5);
    CHECK(bench.ask<Failure>(Commit{}, tag).status == Status::no_transfer);
    CHECK(bench.refusal(Play{.home = Home::ram}) == StatusWithNumber{Status::nothing_in_ram});

    CHECK(bench.upload(LinkBench::begin_for_ram(scene), scene, tag).is_ok());
    bench.device.leased = {};
    CHECK(bench.refusal(Play{.home = Home::ram}) == StatusWithNumber{Status::nothing_in_ram});
}

TEST_CASE("the device hears when nothing will come into its memory")
{
    const Scene scene = padded_scene(2000, 1);
    const auto ended = [&](auto&& end) {
        LinkBench bench;
        bench.ask<Begun>(LinkBench::begin_for_ram(scene), tag);
        end(bench);
        return bench.device.leases_ended;
    };
    CHECK(ended([](LinkBench&) {}) == 0);
    CHECK(ended([](LinkBench& bench) { bench.send(Cancel{}, tag); }) == 1);
    CHECK(ended([](LinkBench& bench) { bench.wait(3001); }) == 1);
    CHECK(ended([&](LinkBench& bench) { bench.send(LinkBench::begin_for_slot(0, "a", scene), 43); }) == 1);
    CHECK(ended([&](LinkBench& bench) { bench.send(LinkBench::begin_for_ram(scene), 43); }) == 0);
    CHECK(ended([&](LinkBench& bench) { bench.send(Begin{.home = Home::ram, .size = 999'999}, 43); }) == 1);
    CHECK(ended([&](LinkBench& bench) { bench.send_blocks(scene, tag), bench.send(Commit{}, tag); }) == 0);
    Scene damaged = scene;
    damaged[9] ^= std::byte{1};
    CHECK(ended([&](LinkBench& bench) { bench.send_blocks(damaged, tag), bench.send(Commit{}, tag); }) == 1);
}

TEST_CASE("the computer is told after every sixteen blocks, and at the end")
{
    Upload upload;
    upload.blocks(0, 15);
    CHECK_FALSE(upload.has_acknowledgement());
    upload.blocks(15, 1);
    CHECK(upload.acknowledgement() == Acknowledgement{.next = 16, .window = 64});
    CHECK_FALSE(upload.has_acknowledgement());
    upload.blocks(16, 16);
    CHECK(upload.acknowledgement() == Acknowledgement{.next = 32, .window = 64});
    upload.blocks(32, 18);
    CHECK(upload.acknowledgement() == Acknowledgement{.next = 50, .window = 64});
    CHECK(upload.is_committed());
}

TEST_CASE("who fetches nothing is told the newest, once")
{
    Upload upload;
    upload.blocks(0, 50);
    CHECK(upload.acknowledgement() == Acknowledgement{.next = 50, .window = 64});
    CHECK_FALSE(upload.has_acknowledgement());
    CHECK(upload.is_committed());
}

TEST_CASE("when a block is missing the computer is told at once, and now and then while it does not hear")
{
    Upload upload;
    upload.blocks(0, 3);
    upload.blocks(4, 1);
    CHECK(upload.acknowledgement() == Acknowledgement{.next = 3, .window = 64, .is_missing = true});
    upload.blocks(5, 15);
    CHECK_FALSE(upload.has_acknowledgement());
    upload.blocks(20, 1);
    CHECK(upload.acknowledgement() == Acknowledgement{.next = 3, .window = 64, .is_missing = true});
    upload.blocks(3, 47);
    CHECK(upload.acknowledgement() == Acknowledgement{.next = 50, .window = 64});
    CHECK(upload.is_committed());
}

TEST_CASE("blocks that come twice are ignored, and the computer is told where it is")
{
    Upload upload;
    upload.blocks(0, 5);
    upload.blocks(2, 1);
    CHECK(upload.acknowledgement() == Acknowledgement{.next = 5, .window = 64});
    upload.blocks(0, 50);
    CHECK(upload.acknowledgement() == Acknowledgement{.next = 50, .window = 64});
    upload.blocks(49, 1);
    CHECK(upload.acknowledgement() == Acknowledgement{.next = 50, .window = 64});
    CHECK(upload.is_committed());
}

TEST_CASE("blocks behind the end are ignored")
{
    Upload upload;
    upload.blocks(0, 50);
    for (const int block : {50, 51, 0x7FFF, 0xFFFF})
        upload.bench.send(Data{.block = static_cast<std::uint16_t>(block)}, tag);
    CHECK(upload.acknowledgement().next == 50);
    CHECK(upload.is_committed());
}

TEST_CASE("commit before the end says what is missing, and the upload goes on")
{
    Upload upload;
    upload.blocks(0, 49);
    upload.bench.last_failure();
    CHECK(upload.commit_refused() == StatusWithNumber{Status::incomplete, 49});
    upload.blocks(49, 1);
    upload.acknowledgement();
    CHECK(upload.is_committed());
}

TEST_CASE("commit asked again is answered again")
{
    Upload upload;
    upload.blocks(0, 50);
    upload.acknowledgement();
    CHECK(upload.is_committed());
    const int operations = upload.bench.flash.operations();
    CHECK(upload.is_committed());
    // Its beginning once more, too: all of it has come.
    CHECK(upload.bench.ask<Begun>(upload.begin, tag) == Begun{.next = 50, .window = 64});
    CHECK(upload.is_committed());
    CHECK(upload.bench.flash.operations() == operations);
    // But not when the slot holds it no more.
    CHECK(upload.bench.does(EraseSlot{.slot = 0}));
    CHECK(upload.commit_refused() == StatusWithNumber{Status::no_transfer});
    CHECK(upload.bench.ask<Begun>(upload.begin, tag) == Begun{.next = 0, .window = 64});
}

TEST_CASE("a beginning that comes twice changes nothing; another one replaces the upload")
{
    Upload upload;
    upload.blocks(0, 16);
    upload.acknowledgement();
    CHECK(upload.bench.ask<Begun>(upload.begin, tag) == Begun{.next = 16, .window = 64});
    upload.blocks(18, 1); // what there would be to tell is nobody's concern any more
    const Scene other = padded_scene(700, 2);
    upload.bench.ask<Begun>(LinkBench::begin_for_slot(1, "other", other), 43);
    CHECK_FALSE(upload.has_acknowledgement());
    upload.blocks(16, 4);
    CHECK(upload.bench.last_failure() == StatusWithNumber{Status::no_transfer});
    CHECK(upload.bench.upload(LinkBench::begin_for_slot(1, "other", other), other, 43).is_ok());
    CHECK(std::ranges::equal(upload.bench.slots.scene(1), other));
    CHECK(upload.bench.slots.entry(0).is_empty());
}

TEST_CASE("a block that was damaged on the way is found at the end, and the slot stays as it was")
{
    Upload upload;
    REQUIRE(upload.bench.upload(upload.begin, upload.scene, tag).is_ok());
    const SlotState before = state_of(upload.bench.slots);
    Scene other = padded_scene(3000, 2);
    for (const bool is_for_ram : {false, true}) {
        const auto begin =
            is_for_ram ? LinkBench::begin_for_ram(other) : LinkBench::begin_for_slot(0, "b", other);
        Scene damaged = other;
        damaged[1234] ^= std::byte{4};
        CHECK(upload.bench.upload(begin, damaged, 43) == StatusWithNumber{Status::bad_checksum});
        CHECK(state_of(Store{upload.bench.flash, small_places}) == before);
        CHECK(upload.bench.refusal(Play{.home = Home::ram}) == StatusWithNumber{Status::nothing_in_ram});
    }
    CHECK(upload.bench.upload(LinkBench::begin_for_slot(0, "b", other), other, 43).is_ok());
}

TEST_CASE("what is no scene is refused at the end")
{
    Upload upload;
    Scene none = padded_scene(3000, 2);
    none[3] = std::byte{99};
    const auto& bench_begin = LinkBench::begin_for_slot(2, "none", none);
    CHECK(upload.bench.upload(bench_begin, none, 43) == StatusWithNumber{Status::unsupported_version});
    CHECK(upload.bench.upload(LinkBench::begin_for_ram(none), none, 44) ==
          StatusWithNumber{Status::unsupported_version});
    CHECK(upload.bench.refusal(Play{.home = Home::ram}) == StatusWithNumber{Status::nothing_in_ram});
    CHECK(upload.bench.slots.entry(2).is_empty());
}

TEST_CASE("an upload of which nothing is heard is dropped, and can be begun again at once")
{
    Upload upload;
    upload.blocks(0, 10);
    upload.bench.wait(2999);
    CHECK_FALSE(upload.has_acknowledgement());
    upload.blocks(10, 1);
    upload.bench.wait(2999);
    CHECK_FALSE(upload.has_acknowledgement());
    upload.bench.wait(1);
    const auto failure = upload.bench.fetch<Failure>(tag);
    CHECK(failure.status == Status::timed_out);
    CHECK(failure.request == 0x11);
    upload.blocks(11, 39);
    CHECK_FALSE(upload.has_acknowledgement());
    CHECK(upload.commit_refused() == StatusWithNumber{Status::timed_out});
    CHECK(upload.bench.ask<Begun>(upload.begin, tag) == Begun{.next = 0, .window = 64});
    upload.blocks(0, 50);
    upload.acknowledgement();
    CHECK(upload.is_committed());
}

TEST_CASE("an upload that is cancelled leaves the slot as it was")
{
    Upload upload;
    upload.blocks(0, 50);
    upload.acknowledgement();
    upload.bench.ask<Done<Kind::cancel>>(Cancel{}, tag);
    CHECK(upload.commit_refused() == StatusWithNumber{Status::no_transfer});
    CHECK(upload.bench.slots.entry(0).is_empty());
    CHECK(upload.bench.refusal(Cancel{}) == StatusWithNumber{Status::no_transfer}); // of another tag
}

TEST_CASE("data without an upload are told once")
{
    LinkBench bench;
    for (std::uint16_t block = 0; block < 100; ++block)
        bench.send(Data{.block = block}, tag);
    CHECK(bench.fetch<Failure>(tag).status == Status::no_transfer);
    CHECK_FALSE(bench.link.has_report());
    CHECK(bench.link_errors() == 100);
}

TEST_CASE("what plays is held while its slot is replaced again and again")
{
    LinkBench bench;
    const Scene first = padded_scene(9000, 1);
    REQUIRE(bench.upload(LinkBench::begin_for_slot(0, "a", first), first, tag).is_ok());
    REQUIRE(bench.does(Play{.home = Home::slot, .slot = 0}));
    const auto played = bench.device.played();
    for (std::uint8_t round = 1; round < 8; ++round) {
        const Scene next = padded_scene(9000, round + 1U);
        REQUIRE(bench.upload(LinkBench::begin_for_slot(0, "a", next), next, round).is_ok());
        CHECK(std::ranges::equal(played, bench.device.shown));
    }
}

}
