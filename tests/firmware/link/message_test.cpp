#include "firmware/link/fields.hpp"
#include "firmware/link/input_message.hpp"
#include "firmware/link/message.hpp"
#include "firmware/link/upload_message.hpp"

#include "tests/bytes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>
#include <random>

namespace kfast::test {

using namespace link;

namespace {

/// Whether the message is these bytes and then zeros, with tag 0x5A, and comes back from them.
template <class M>
bool is_written_as(const M& message, std::initializer_list<int> values)
{
    const Report report = report_of(message, 0x5A);
    std::vector<std::byte> expected = bytes(values);
    expected.resize(report_bytes);
    CHECK(std::ranges::equal(report.bytes, expected));
    const auto back = message_of<M>(report);
    REQUIRE(back);
    CHECK(report_of(*back, 0x5A) == report);
    return true;
}

}

TEST_CASE("messages lie in their reports as the document says")
{
    is_written_as(Hello{}, {0x01, 0x5A});
    is_written_as(Capabilities{.slots = 8,
                               .panel = {240, 320},
                               .block_bytes = 0x01020304,
                               .ram_bytes = 0x8000,
                               .pool_bytes = 0x17E000,
                               .room_bytes = 0x1000,
                               .serial = {"E6"}},
                  {0x81, 0x5A, 2, 8, 240,  0,    0x40, 0x01, 4,    3, 2, 1,   0,
                   0x80, 0,    0, 0, 0xE0, 0x17, 0,    0,    0x10, 0, 0, 'E', '6'});
    is_written_as(Names{.firmware = {"0.1"}, .board = {"p"}, .panel = {"q"}},
                  {0x82, 0x5A, '0', '.', '1', 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 'p', 0, 0, 0,  0,
                   0,    0,    0,   0,   0,   0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 'q'});
    is_written_as(Playing{.is_playing = true,
                          .is_paused = true,
                          .home = Home::slot,
                          .slot = 3,
                          .brightness = 200,
                          .inputs = 2,
                          .canvas = {64, 48},
                          .frame_rate = 30'000,
                          .length = Time::frame(60),
                          .moment = Time{1},
                          .speed = -65536,
                          .clip = {"up"},
                          .arming = Arming::armed,
                          .restarts = {.count = 2, .home = Home::ram, .slot = 5}},
                  {0x83, 0x5A, 1, 1, 1, 3, 200, 2,    64,   0,   48,  0, 0x30, 0x75, 0, 0, 0, 0xF0, 0,
                   0,    1,    0, 0, 0, 0, 0,   0xFF, 0xFF, 'u', 'p', 0, 0,    0,    0, 0, 0, 0,    0,
                   0,    0,    0, 0, 0, 0, 0,   0,    0,    0,   0,   0, 0,    0,    2, 2, 2, 5});
    is_written_as(Statistics{.frames = 1, .late = 2, .skipped = 3, .link_errors = 4, .coarse = 5},
                  {0x84, 0x5A, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0, 5});
    is_written_as(Begin{.home = Home::ram, .slot = 255, .size = 0x010203, .crc = 0xA1B2C3D4, .name = {"n"}},
                  {0x10, 0x5A, 2, 255, 3, 2, 1, 0, 0xD4, 0xC3, 0xB2, 0xA1, 'n'});
    is_written_as(Begun{.next = 0x0102, .window = 64}, {0x90, 0x5A, 2, 1, 64, 0, 0});
    is_written_as(Acknowledgement{.next = 7, .window = 64, .is_missing = true}, {0x91, 0x5A, 7, 0, 64, 0, 1});
    is_written_as(Commit{}, {0x12, 0x5A});
    is_written_as(Done<Kind::commit>{}, {0x92, 0x5A});
    is_written_as(Cancel{}, {0x13, 0x5A});
    is_written_as(AskSlot{.slot = 7}, {0x20, 0x5A, 7});
    is_written_as(SlotContents{.slot = 7, .is_chosen = true, .size = 5, .crc = 6, .name = {"ab"}},
                  {0xA0, 0x5A, 7, 1, 5, 0, 0, 0, 6, 0, 0, 0, 'a', 'b'});
    is_written_as(EraseSlot{.slot = 1}, {0x21, 0x5A, 1});
    is_written_as(ChooseSlot{}, {0x22, 0x5A, 255});
    is_written_as(Play{.home = Home::slot, .slot = 2, .clip = {"c"}}, {0x30, 0x5A, 1, 2, 'c'});
    is_written_as(Pause{}, {0x31, 0x5A});
    is_written_as(Resume{}, {0x32, 0x5A});
    is_written_as(Seek{.moment = Time{-2}}, {0x33, 0x5A, 0xFE, 0xFF, 0xFF, 0xFF});
    is_written_as(Speed{.speed = 0x8000}, {0x34, 0x5A, 0, 0x80, 0, 0});
    is_written_as(Brightness{.brightness = 77}, {0x35, 0x5A, 77});
    Inputs inputs{.count = 2};
    inputs.places = {{{.input = 4, .place = Time{65536}}, {.input = 1, .place = Time{2}}}};
    is_written_as(inputs, {0x36, 0x5A, 2, 4, 0, 0, 1, 0, 1, 2, 0, 0, 0});
    Text text{.input = 3, .length = 2};
    text.bytes[0] = std::byte{'5'};
    text.bytes[1] = std::byte{'%'};
    is_written_as(text, {0x37, 0x5A, 3, 2, '5', '%'});
    is_written_as(AskInput{.input = 31}, {0x05, 0x5A, 31});
    is_written_as(InputState{.input = 3,
                             .takes = InputKind::number,
                             .name = {"gaze"},
                             .min = -1000,
                             .max = 1'000'000,
                             .default_value = 1,
                             .place = Time{65536}},
                  {0x85, 0x5A, 3,    0,    'g',  'a', 'z', 'e', 0, 0, 0, 0, 0, 0,    0,
                   0,    0,    0,    0,    0,    0,   0,   0,   0, 0, 0, 0, 0, 0x18, 0xFC,
                   0xFF, 0xFF, 0x40, 0x42, 0x0F, 0,   1,   0,   0, 0, 0, 0, 1, 0});
    is_written_as(Play{.home = Home::start}, {0x30, 0x5A, 4, 255});
    is_written_as(Silence{.milliseconds = 0x0102, .action = SilenceAction::start}, {0x3A, 0x5A, 2, 1, 1});
    is_written_as(EnterBootLoader{}, {0x3F, 0x5A});
    is_written_as(Failure{.request = 0x10, .status = Status::no_room, .number = 0x1000, .text = {"no"}},
                  {0xFF, 0x5A, 0x10, 25, 0, 0x10, 0, 0, 'n', 'o'});
}

TEST_CASE("a block carries sixty bytes of the scene")
{
    CHECK(block_bytes == 60);
    Data data{.block = 0x0A0B};
    data.bytes.fill(std::byte{0xEE});
    const Report report = report_of(data, 3);
    CHECK(std::ranges::equal(std::span{report.bytes}.first(4), bytes({0x11, 3, 0x0B, 0x0A})));
    CHECK(std::ranges::count(report.bytes, std::byte{0xEE}) == 60);
    CHECK(message_of<Data>(report)->bytes == data.bytes);
}

TEST_CASE("scenes have as many blocks as it takes")
{
    CHECK(blocks_of(1) == 1);
    CHECK(blocks_of(60) == 1);
    CHECK(blocks_of(61) == 2);
    CHECK(blocks_of(0xFFFFFFFF) == 71'582'789);
}

TEST_CASE("a report of another kind, or with a number that means nothing, is no such message")
{
    CHECK_FALSE(message_of<Pause>(report_of(Resume{}, 1)));
    CHECK_FALSE(message_of<Begin>(report_of(Begun{}, 1))); // from the other side
    Report report = report_of(Begin{}, 1);
    report.bytes[2] = std::byte{5};
    CHECK_FALSE(message_of<Begin>(report));
    report = report_of(Silence{}, 1);
    report.bytes[4] = std::byte{2};
    CHECK_FALSE(message_of<Silence>(report));
    report = report_of(Acknowledgement{}, 1);
    report.bytes[6] = std::byte{2};
    CHECK_FALSE(message_of<Acknowledgement>(report));
}

TEST_CASE("what stands behind the end of a text is not read")
{
    Report report = report_of(Play{.clip = {"walk"}}, 1);
    report.bytes[4 + 6] = std::byte{'x'};
    const auto play = message_of<Play>(report);
    REQUIRE(play);
    CHECK(play->clip == Name{"walk"});
    CHECK(Name{"123456789012345678901234"}.view().size() == 24);
}

TEST_CASE("every status has a text that a report has room for")
{
    for (int code = 0; code < 256; ++code)
        CHECK(status_text(static_cast<Status>(code)).size() <= longest_status_text);
    CHECK(status_text(Status::bad_scene) == "a value is out of its range or refers to nothing");
    CHECK(status_text(Status::no_such_clip) == "the scene has no clip of that name");
    CHECK(status_text(static_cast<Status>(8)).empty());
    CHECK(status_text(Status::too_slow) == "a picture of the scene takes longer than a second");
    CHECK(status_of(Error::block_too_small) == Status::block_too_small);
    CHECK(static_cast<int>(Status::unsupported) == 31); // as the document counts them
    CHECK(static_cast<int>(Status::no_text) == 35);
}

}
