#include "tests/firmware/link/link_bench.hpp"

#include <doctest/doctest.h>

#include <random>

namespace kfast::test {

using namespace link;

namespace {

constexpr std::uint8_t tag = 42;

}

TEST_CASE("the device tells what it is")
{
    LinkBench bench;
    const auto capabilities = bench.ask<Capabilities>(Hello{});
    CHECK(capabilities.protocol == 2);
    CHECK(capabilities.slots == 8);
    CHECK(capabilities.panel == Size{240, 135});
    CHECK(capabilities.block_bytes == 100'000);
    CHECK(capabilities.ram_bytes == 20'000);
    CHECK(capabilities.pool_bytes == 12 * 4096);
    CHECK(capabilities.room_bytes == 12 * 4096);
    CHECK(capabilities.serial.view() == "E66058388341A22C");
    const auto names = bench.ask<Names>(AskNames{});
    CHECK(names.firmware.view() == "0.1.0");
    CHECK(names.board.view() == "pico");
    CHECK(names.panel.view() == "st7789");
    const auto statistics = bench.ask<Statistics>(AskStatistics{});
    CHECK(statistics.frames == 1000);
    CHECK(statistics.late == 3);
    CHECK(statistics.skipped == 2);
    CHECK(statistics.coarse == 1);
    CHECK(statistics.link_errors == 0);
}

TEST_CASE("a scene goes into a slot, is listed, chosen, played and erased")
{
    LinkBench bench;
    const Scene scene = padded_scene(9001, 1);
    CHECK(bench.upload(LinkBench::begin_for_slot(3, "eyes", scene), scene, tag).is_ok());

    CHECK(bench.does(ChooseSlot{.slot = 3}));
    auto slot = bench.ask<SlotContents>(AskSlot{.slot = 3});
    CHECK(slot.slot == 3);
    CHECK(slot.is_chosen);
    CHECK(slot.size == 9001);
    CHECK(slot.crc == crc_of(scene));
    CHECK(slot.name.view() == "eyes");
    CHECK(bench.ask<Capabilities>(Hello{}).room_bytes == 9 * 4096);

    CHECK(bench.does(Play{.home = Home::slot, .slot = 3}));
    CHECK(bench.device.selection.home == Home::slot);
    CHECK(bench.device.selection.slot == 3);
    CHECK(bench.device.shown.size() == SceneView::parse(scene)->size());
    CHECK(std::equal(bench.device.shown.begin(), bench.device.shown.end(), scene.begin()));
    CHECK(bench.ask<Playing>(AskPlaying{}).slot == 3);

    CHECK(bench.does(ChooseSlot{}));
    CHECK_FALSE(bench.ask<SlotContents>(AskSlot{.slot = 3}).is_chosen);
    CHECK(bench.does(EraseSlot{.slot = 3}));
    slot = bench.ask<SlotContents>(AskSlot{.slot = 3});
    CHECK(slot.size == 0);
    CHECK(slot.name.view().empty());
    CHECK(bench.refusal(Play{.home = Home::slot, .slot = 3}) == StatusWithNumber{Status::empty_slot});
}

TEST_CASE("a scene goes into RAM and plays from there, a clip as well")
{
    LinkBench bench;
    const Scene scene = padded_scene(2000, 1);
    CHECK(bench.refusal(Play{.home = Home::ram}) == StatusWithNumber{Status::nothing_in_ram});
    CHECK(bench.upload(LinkBench::begin_for_ram(scene), scene, tag).is_ok());
    CHECK(bench.flash.operations() == 0);
    CHECK(bench.does(Play{.home = Home::ram, .slot = 5}));
    CHECK(bench.device.ram == scene);
    CHECK(bench.device.selection.home == Home::ram);
    CHECK(bench.device.selection.slot == no_slot);

    CHECK(bench.does(Play{.home = Home::here, .clip = {"rise"}}));
    CHECK(bench.device.selection.home == Home::ram);
    CHECK(bench.device.selection.clip == Name{"rise"});
    CHECK(bench.refusal(Play{.clip = {"fall"}}) == StatusWithNumber{Status::no_such_clip});
    CHECK(bench.device.selection.clip == Name{"rise"});

    // A new one takes its place, and until it is whole there is none.
    bench.ask<Begun>(LinkBench::begin_for_ram(scene), 43);
    CHECK_FALSE(bench.device.playing().is_playing);
    CHECK(bench.refusal(Play{.home = Home::ram}) == StatusWithNumber{Status::nothing_in_ram});
    CHECK(bench.refusal(Play{.home = Home::here}) == StatusWithNumber{Status::nothing_plays});
}

TEST_CASE("the built-in scene plays when asked for, if it is one")
{
    LinkBench bench;
    CHECK(bench.does(Play{.home = Home::built_in}));
    CHECK(bench.device.shown.size() == SceneView::parse(bench.device.built_in_scene)->size());
    bench.device.built_in_scene.assign(100, std::byte{0xFF});
    CHECK(bench.refusal(Play{.home = Home::built_in}) == StatusWithNumber{Status::no_scene});
    bench.device.built_in_scene.assign(100, std::byte{0x5A});
    CHECK(bench.refusal(Play{.home = Home::built_in}) == StatusWithNumber{Status::bad_magic});
    bench.device.built_in_scene = padded_scene(2000, 2);
    bench.device.largest_that_plays = 10;
    CHECK(bench.refusal(Play{.home = Home::built_in}) == StatusWithNumber{Status::block_too_small});
}

TEST_CASE("playing is steered")
{
    LinkBench bench;
    CHECK(bench.does(Play{.home = Home::built_in}));
    CHECK(bench.does(Pause{}));
    CHECK(bench.device.now.is_paused);
    CHECK(bench.does(Resume{}));
    CHECK_FALSE(bench.device.now.is_paused);
    CHECK(bench.does(Seek{.moment = Time{-5}}));
    CHECK(bench.device.now.moment == Time{-5});
    CHECK(bench.does(Speed{.speed = -16 * 65536}));
    CHECK(bench.device.now.speed == -16 * 65536);
    CHECK(bench.refusal(Speed{.speed = 16 * 65536 + 1}) == StatusWithNumber{Status::bad_value});
    CHECK(bench.refusal(Speed{.speed = -16 * 65536 - 1}) == StatusWithNumber{Status::bad_value});
    CHECK(bench.does(Brightness{.brightness = 12}));
    CHECK(bench.device.now.brightness == 12);
    CHECK_FALSE(bench.device.is_in_boot_loader);
    CHECK(bench.does(EnterBootLoader{}));
    CHECK(bench.device.is_in_boot_loader);
}

TEST_CASE("a laser is armed and disarmed, and what is none is not")
{
    LinkBench bench;
    CHECK(bench.refusal(Arm{}) == StatusWithNumber{Status::no_laser});
    CHECK(bench.refusal(Disarm{}) == StatusWithNumber{Status::no_laser});
    bench.device.now.arming = Arming::disarmed;
    CHECK(bench.does(Arm{}));
    CHECK(bench.device.now.arming == Arming::armed);
    CHECK(bench.does(Disarm{}));
    CHECK(bench.device.now.arming == Arming::disarmed);
}

TEST_CASE("a laser is dark before flash is changed, during which nobody could disarm it")
{
    LinkBench bench;
    bench.device.now.arming = Arming::disarmed;
    const auto is_dark_after = [&bench](const auto& request) {
        REQUIRE(bench.does(Arm{}));
        bench.send(request, 7);
        while (bench.link.next_report())
            continue;
        return bench.device.now.arming == Arming::disarmed;
    };
    CHECK(is_dark_after(Begin{.home = Home::slot, .slot = 1, .size = 40}));
    CHECK(is_dark_after(EraseSlot{1}));
    CHECK(is_dark_after(ChooseSlot{1}));
    CHECK_FALSE(is_dark_after(Begin{.home = Home::ram, .size = 40}));
}

TEST_CASE("inputs are set together, or none of them")
{
    LinkBench bench;
    CHECK(bench.refusal(Inputs{.count = 1}) == StatusWithNumber{Status::no_such_input, 0});
    CHECK(bench.does(Play{.home = Home::built_in}));
    Inputs inputs{.count = 2};
    inputs.places = {{{1, Time{65536}}, {0, Time{7}}, {9, Time{-1}}}};
    CHECK(bench.does(inputs));
    CHECK(bench.device.inputs == std::map<std::uint32_t, Time>{{0, Time{7}}, {1, Time{65536}}});

    bench.device.inputs.clear();
    inputs.places[1] = {2, Time{0}};
    CHECK(bench.refusal(inputs) == StatusWithNumber{Status::no_such_input, 2});
    inputs.places[1] = {0, Time{65537}};
    CHECK(bench.refusal(inputs) == StatusWithNumber{Status::bad_value});
    inputs.places[1] = {0, Time{-1}};
    CHECK(bench.refusal(inputs) == StatusWithNumber{Status::bad_value});
    inputs.count = 13;
    CHECK(bench.refusal(inputs) == StatusWithNumber{Status::bad_value});
    CHECK(bench.device.inputs.empty());
}

TEST_CASE("a text is as long as it says, and for an input that is one")
{
    LinkBench bench;
    Text text{.input = 1, .length = 5};
    std::ranges::copy(std::as_bytes(std::span{"12:456", 6}), text.bytes.begin());
    CHECK(bench.refusal(text) == StatusWithNumber{Status::no_such_input, 0});
    CHECK(bench.does(Play{.home = Home::built_in}));
    CHECK(bench.does(text));
    CHECK(bench.device.texts[1] == "12:45");
    text.length = 0;
    CHECK(bench.does(text));
    CHECK(bench.device.texts[1].empty());
    text.length = Text::max;
    CHECK(bench.does(text));
    CHECK(bench.device.texts[1].size() == 60);

    text.length = Text::max + 1;
    CHECK(bench.refusal(text) == StatusWithNumber{Status::bad_value});
    CHECK(bench.device.texts[1].size() == 60);
    text = {.input = 2, .length = 0};
    CHECK(bench.refusal(text) == StatusWithNumber{Status::no_such_input, 2});
    text.input = PretendDevice::no_text;
    CHECK(bench.refusal(text) == StatusWithNumber{Status::no_text});
    CHECK(bench.device.texts.size() == 1);
}

TEST_CASE("with tag 0 only failures are answered")
{
    LinkBench bench;
    bench.send(Play{.home = Home::built_in}, 0);
    for (int update = 0; update < 1000; ++update) {
        Inputs inputs{.count = 1};
        inputs.places[0] = {1, Time{update}};
        bench.send(inputs, 0);
    }
    CHECK(bench.device.inputs[1] == Time{999});
    CHECK_FALSE(bench.link.has_report());
    bench.send(Inputs{.count = 14}, 0);
    CHECK(bench.fetch<Failure>(0).status == Status::bad_value);
}

TEST_CASE("slots that there are not are refused")
{
    LinkBench bench;
    const StatusWithNumber none{Status::no_such_slot, 8};
    CHECK(bench.refusal(AskSlot{.slot = 8}) == none);
    CHECK(bench.refusal(EraseSlot{.slot = 8}) == none);
    CHECK(bench.refusal(ChooseSlot{.slot = 8}) == none);
    CHECK(bench.refusal(Play{.home = Home::slot, .slot = 255}) == none);
    CHECK(bench.refusal(Begin{.home = Home::slot, .slot = 8, .size = 1}) == none);
    CHECK(bench.refusal(EraseSlot{.slot = 0}) == StatusWithNumber{Status::empty_slot});
    CHECK(bench.refusal(ChooseSlot{.slot = 0}) == StatusWithNumber{Status::empty_slot});
}

TEST_CASE("an upload that cannot be is refused at its beginning")
{
    LinkBench bench;
    CHECK(bench.refusal(Begin{.home = Home::slot, .slot = 0, .size = 0}) ==
          StatusWithNumber{Status::bad_value});
    CHECK(bench.refusal(Begin{.home = Home::built_in, .slot = 0, .size = 9}) ==
          StatusWithNumber{Status::bad_value});
    CHECK(bench.refusal(Begin{.home = Home::slot, .slot = 0, .size = 0xFFFF * 60 + 1}) ==
          StatusWithNumber{Status::bad_value});
    CHECK(bench.refusal(Begin{.home = Home::slot, .slot = 0, .size = 0xFFFF * 60}) ==
          StatusWithNumber{Status::no_room, 12 * 4096});
    CHECK(bench.refusal(Begin{.home = Home::ram, .size = 20'001}) ==
          StatusWithNumber{Status::too_large, 20'000});
}

TEST_CASE("an input is told by its number")
{
    LinkBench bench;
    CHECK(bench.refusal(AskInput{.input = 0}) == StatusWithNumber{Status::nothing_plays});
    CHECK(bench.does(Play{.home = Home::built_in}));
    CHECK(bench.refusal(AskInput{.input = 2}) == StatusWithNumber{Status::no_such_input, 2});
    bench.device.inputs[1] = Time{77};
    const auto input = bench.ask<InputState>(AskInput{.input = 1});
    CHECK(input.input == 1);
    CHECK(input.name.view() == "gaze");
    CHECK(input.place == Time{77});
}

TEST_CASE("the scene of the start is that of the chosen slot, or the built-in one")
{
    LinkBench bench;
    bench.device.start_clip = {"rise"};
    const Scene scene = padded_scene(1000, 1);
    CHECK(bench.upload(LinkBench::begin_for_slot(3, "eyes", scene), scene, tag).is_ok());
    CHECK(bench.does(Play{.home = Home::start}));
    CHECK(bench.device.selection.home == Home::built_in);
    CHECK(bench.device.selection.slot == no_slot);
    CHECK(bench.device.selection.clip == Name{"rise"});

    CHECK(bench.does(ChooseSlot{.slot = 3}));
    CHECK(bench.link.play_start().is_ok());
    CHECK(bench.device.selection.home == Home::slot);
    CHECK(bench.device.selection.slot == 3);
    CHECK(bench.device.selection.clip == Name{"rise"});
    bench.device.start_clip = {"fall"}; // which no scene has
    CHECK(bench.does(Play{.home = Home::start, .clip = {"rise"}}));
    CHECK(bench.device.selection.clip == Name{"rise"});
    CHECK(bench.does(Play{.home = Home::start}));
    CHECK(bench.device.selection.clip == Name{});
    CHECK(bench.refusal(Play{.home = Home::start, .clip = {"fall"}}) ==
          StatusWithNumber{Status::no_such_clip});

    bench.flash.damage(small_places.pool + bench.slots.entry(3).offset + 40);
    CHECK(bench.does(Play{.home = Home::start}));
    CHECK(bench.device.selection.home == Home::built_in);
    bench.device.built_in_scene[0] ^= std::byte{1};
    CHECK(bench.refusal(Play{.home = Home::start}) == StatusWithNumber{Status::bad_magic});
    CHECK(bench.device.now.is_playing);
    bench.device.built_in_scene.assign(100, std::byte{0xFF});
    CHECK(bench.does(Play{.home = Home::start}));
    CHECK_FALSE(bench.device.now.is_playing);
}

TEST_CASE("an upload moves behind a sector that does not hold, and its computer does not notice")
{
    LinkBench bench;
    bench.flash.spoil(small_places.pool + sector_bytes, Fault::program_error);
    const Scene scene = padded_scene(3 * sector_bytes, 1);
    CHECK(bench.upload(LinkBench::begin_for_slot(3, "eyes", scene), scene, 9).is_ok());
    CHECK(bench.slots.entry(3).offset == 2 * sector_bytes);
    CHECK(bench.does(Play{.home = Home::slot, .slot = 3}));
}

TEST_CASE("a slot in whose place another scene lies does not play")
{
    LinkBench bench;
    const Scene scene = padded_scene(sector_bytes, 1);
    const Scene other = padded_scene(sector_bytes, 2);
    REQUIRE(bench.upload(LinkBench::begin_for_slot(3, "eyes", scene), scene, 9).is_ok());
    REQUIRE(bench.does(ChooseSlot{.slot = 3}));
    const std::uint32_t place = small_places.pool + bench.slots.entry(3).offset;
    bench.flash.erase(place);
    for (std::uint32_t at = 0; at < sector_bytes; at += page_bytes)
        bench.flash.program(place + at, std::span{other}.subspan(at).first<page_bytes>());
    REQUIRE(SceneView::parse(bench.slots.scene(3)));
    CHECK(bench.refusal(Play{.home = Home::slot, .slot = 3}) == StatusWithNumber{Status::bad_checksum});
    CHECK(bench.link.play_start().is_ok());
    CHECK(bench.device.selection.home == Home::built_in);
}

TEST_CASE("reports that mean nothing are refused and counted")
{
    LinkBench bench;
    Report report;
    int wrong = 0;
    for (int kind = 0; kind < 256; ++kind) {
        report.bytes[0] = static_cast<std::byte>(kind);
        report.bytes[1] = std::byte{7};
        const bool is_known = (kind >= 1 && kind <= 5) || (kind >= 0x10 && kind <= 0x13) ||
                              (kind >= 0x20 && kind <= 0x22) || (kind >= 0x30 && kind <= 0x3C) ||
                              kind == 0x3F;
        if (is_known)
            continue;
        ++wrong;
        bench.link.take(with_checksum(report).bytes, bench.now);
        const auto failure = bench.fetch<Failure>(7);
        CHECK(failure.request == kind);
        CHECK(failure.status == Status::unknown_kind);
    }
    for (std::size_t size = 0; size < 64; ++size) {
        const Report pause = report_of(Pause{}, 1);
        bench.link.take(std::span{pause.bytes}.first(size), bench.now);
        const auto failure = bench.fetch<Failure>(size > 1 ? 1 : 0);
        CHECK(failure.status == Status::bad_report);
        ++wrong;
    }
    std::vector<std::byte> long_one(65, std::byte{0});
    bench.link.take(long_one, bench.now);
    CHECK(bench.last_failure() == StatusWithNumber{Status::bad_report});
    CHECK_FALSE(bench.device.now.is_paused);
    CHECK(bench.link_errors() == static_cast<std::uint32_t>(wrong + 1));
}

TEST_CASE("requests for whose answers there is no room are not carried out")
{
    LinkBench bench;
    for (int request = 0; request < 8; ++request)
        bench.send(Resume{}, 5);
    bench.send(Pause{}, 6);
    CHECK_FALSE(bench.device.now.is_paused);
    for (int request = 0; request < 8; ++request)
        bench.fetch<Done<Kind::resume>>(5);
    CHECK_FALSE(bench.link.has_report());
    CHECK(bench.does(Pause{}));
    CHECK(bench.device.now.is_paused);
    CHECK(bench.link_errors() == 1);
}

TEST_CASE("any reports at all leave a device that takes an upload")
{
    LinkBench bench;
    std::mt19937 random{3};
    for (int round = 0; round < 50'000; ++round) {
        Report report;
        for (std::byte& byte : report.bytes)
            byte = static_cast<std::byte>(random() % 3 == 0 ? random() & 7 : random() & 255);
        report.bytes[0] = static_cast<std::byte>(random() & 0x3F);
        bench.link.take(std::span{report.bytes}.first(random() % 9 == 0 ? random() % 64 : 64), bench.now);
        if (random() % 4 == 0)
            bench.link.next_report();
        if (random() % 100 == 0)
            bench.wait(static_cast<std::uint32_t>(random() % 4000));
    }
    bench.last_failure();
    const Scene scene = padded_scene(5000, 1);
    CHECK(bench.upload(LinkBench::begin_for_slot(0, "a", scene), scene, tag).is_ok());
    CHECK(state_of(Store{bench.flash, small_places}).slots[0].scene == scene);
}

}
