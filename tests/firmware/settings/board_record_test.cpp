#include "firmware/settings/board_record.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

namespace {

BoardSettings unusual_settings()
{
    BoardSettings settings;
    settings.panel = {.controller = Controller::st7735,
                      .glass = {80, 160},
                      .column = 26,
                      .row = 1,
                      .rotation = Rotation::three_quarters,
                      .bgr = true,
                      .inverted = true,
                      .tearing_effect = true,
                      .brightness = 77};
    settings.bus = BusKind::parallel_8;
    settings.bus_clock = 13'888'888;
    settings.i2c_address = 0x3D;
    settings.pin(PinRole::clock) = 8;
    settings.pin(PinRole::data) = 0;
    settings.pin(PinRole::log) = 16;
    settings.clip = {"idle"};
    settings.controls[0] = {ControlKind::button, ControlAction::sleep, 20, {}};
    settings.controls[1] = {ControlKind::button, ControlAction::input, 14, {"open"}};
    settings.controls[2] = {ControlKind::knob, ControlAction::input, 27, {"an input of 24 bytes too"}};
    settings.controls[7] = {ControlKind::knob, ControlAction::place, 26, {"a clip of 24 bytes here!"}};
    return settings;
}

}

BoardSettings beam_settings()
{
    BoardSettings settings = unusual_settings();
    settings.bus = BusKind::dac;
    settings.pin(PinRole::ldac) = 16;
    settings.pin(PinRole::blank) = 20;
    settings.controls[3] = {ControlKind::button, ControlAction::arm, 12, {}};
    settings.beam = {.rate = 123'456,
                     .lit_step = 655,
                     .travel_step = 3277,
                     .corner_dwell = 8,
                     .lit_dwell = 2,
                     .arrival_dwell = 6,
                     .leave_dwell = 3,
                     .light_delay = 4,
                     .min_refresh = 20,
                     .resolution = 4096,
                     .brightness = BeamBrightness::by_speed,
                     .park = {-32768, 32767},
                     .is_laser = true};
    return settings;
}

TEST_CASE("settings come back from their record as they were")
{
    CHECK(read_board_record(board_record({})) == BoardSettings{});
    CHECK(read_board_record(board_record(unusual_settings())) == unusual_settings());
    CHECK(read_board_record(board_record(beam_settings())) == beam_settings());
}

TEST_CASE("what is about no beam is a record that older firmware reads")
{
    const auto version_of = [](const BoardSettings& settings) {
        return std::to_integer<int>(board_record(settings)[4]);
    };
    CHECK(version_of({}) == 1);
    CHECK(version_of(unusual_settings()) == 1);
    CHECK(version_of(beam_settings()) == 2);
    BoardSettings settings;
    settings.bus = BusKind::dac;
    CHECK(version_of(settings) == 2);
    settings = {};
    settings.pin(PinRole::blank) = 20;
    CHECK(version_of(settings) == 2);
    settings = {};
    settings.controls[7].action = ControlAction::arm;
    CHECK(version_of(settings) == 2);
    settings = {};
    settings.beam.is_laser = true;
    CHECK(version_of(settings) == 2);
}

TEST_CASE("a record may be followed by the rest of its sector")
{
    std::array<std::byte, 4096> sector;
    sector.fill(std::byte{0xFF});
    std::ranges::copy(board_record(unusual_settings()), sector.begin());
    CHECK(read_board_record(sector) == unusual_settings());
}

TEST_CASE("fields lie where their description says")
{
    const BoardRecord record = board_record(unusual_settings());
    const std::span bytes{record};
    CHECK(std::ranges::equal(bytes.first(24),
                             test::bytes({'K', 'F', 'B', 'S', 1,  0, 0x12, 0x01, 2, 3,    7, 77,
                                          80,  0,   160, 0,   26, 0, 1,    0,    2, 0x3D, 8, 0})));
    CHECK(
        std::ranges::equal(bytes.subspan(30, 8), test::bytes({0x78, 0xED, 0xD3, 0x00, 'i', 'd', 'l', 'e'})));
    CHECK(std::ranges::equal(bytes.subspan(86, 9), test::bytes({1, 6, 14, 0, 'o', 'p', 'e', 'n', 0})));
    CHECK(std::ranges::equal(bytes.subspan(114, 6), test::bytes({2, 6, 27, 0, 'a', 'n'})));
    CHECK(std::ranges::equal(bytes.subspan(254, 6), test::bytes({2, 3, 26, 0, 'a', ' '})));
}

TEST_CASE("fields of a beam lie behind those of panels")
{
    const BoardRecord record = board_record(beam_settings());
    const std::span bytes{record};
    REQUIRE(bytes.size() == 8 + 274 + 24 + 4);
    CHECK(std::ranges::equal(bytes.first(8), test::bytes({'K', 'F', 'B', 'S', 2, 0, 0x2A, 0x01})));
    CHECK(std::ranges::equal(bytes.subspan(8 + 274, 24),
                             test::bytes({16, 20, 0x40, 0xE2, 0x01, 0x00, 0x8F, 0x02, 0xCD, 0x0C, 8,   2, 6,
                                          3,  4,  20,   0x00, 0x10, 2,    1,    0x00, 0x80, 0xFF, 0x7F})));
}

TEST_CASE("a record with any bit wrong is none")
{
    for (const BoardRecord& record : {board_record(unusual_settings()), board_record(beam_settings())}) {
        for (std::size_t bit = 0; bit < 8 * record.size(); ++bit) {
            BoardRecord damaged = record;
            damaged[bit / 8] ^= std::byte{1} << bit % 8;
            CHECK_FALSE(read_board_record(damaged));
        }
    }
}

TEST_CASE("what is shorter than a record is none")
{
    for (const BoardRecord& record : {board_record({}), board_record(beam_settings())}) {
        for (std::size_t size = 0; size < record.size(); ++size)
            CHECK_FALSE(read_board_record(std::span{record}.first(size)));
    }
}

TEST_CASE("whatever has a name can be stored")
{
    const auto comes_back = [](const BoardSettings& settings) {
        return read_board_record(board_record(settings)) == settings;
    };
    BoardSettings settings;
    for (std::size_t number = 0; number < controller_names.size(); ++number) {
        settings.panel.controller = static_cast<Controller>(number);
        CHECK(comes_back(settings));
    }
    for (std::size_t number = 0; number < bus_names.size(); ++number) {
        settings.bus = static_cast<BusKind>(number);
        CHECK(comes_back(settings));
    }
    for (std::size_t number = 0; number < control_action_names.size(); ++number) {
        settings.controls[0].action = static_cast<ControlAction>(number);
        CHECK(comes_back(settings));
    }
}

TEST_CASE("a number without a meaning makes a record none, though its checksum is right")
{
    BoardSettings settings;
    settings.panel.controller = static_cast<Controller>(controller_names.size());
    CHECK_FALSE(read_board_record(board_record(settings)));
    settings = {};
    settings.bus = static_cast<BusKind>(bus_names.size());
    CHECK_FALSE(read_board_record(board_record(settings)));
    settings = {};
    settings.controls[3].action = static_cast<ControlAction>(control_action_names.size());
    CHECK_FALSE(read_board_record(board_record(settings)));
    settings = {};
    settings.beam.brightness = static_cast<BeamBrightness>(3);
    CHECK_FALSE(read_board_record(board_record(settings)));
}

TEST_CASE("what came with beams has no meaning in a record of version 1")
{
    const auto changed = [](std::size_t place, std::uint8_t number) {
        BoardRecord record = board_record({});
        record[place] = std::byte{number};
        Crc32 crc;
        crc.add(std::span{record}.first(record.size() - 4));
        for (std::size_t i = 0; i < 4; ++i)
            record[record.size() - 4 + i] = static_cast<std::byte>(crc.value() >> 8 * i);
        return read_board_record(record);
    };
    constexpr std::size_t bus = 20;
    constexpr std::size_t first_action = 58 + 1;
    CHECK(changed(bus, 2));
    CHECK_FALSE(changed(bus, 3));
    CHECK(changed(first_action, 6));
    CHECK_FALSE(changed(first_action, 7));
}

}
