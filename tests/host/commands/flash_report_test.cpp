#include "host/commands/flash/flash_report.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

FlashOutcome three_sectors()
{
    FlashOutcome outcome{.contents = "firmware of 5000 bytes, scene of 300 bytes",
                         .addresses = {0x1000'0000, 0x1000'1000, 0x1004'0000}};
    outcome.port = "1-2";
    return outcome;
}

PlayerOutcome playing_built_in()
{
    PlayerOutcome player{"E66058388341A22C", {}, std::nullopt};
    player.playing.is_playing = true;
    player.playing.home = link::Home::built_in;
    player.playing.length = Time::frame(60);
    player.playing.speed = 0x1'0000;
    return player;
}

constexpr const char* heading = "firmware of 5000 bytes, scene of 300 bytes: 3 sectors\n";

}

TEST_CASE("it is told how much was written")
{
    FlashOutcome outcome = three_sectors();
    outcome.differing = {0x1004'0000};
    outcome.written = 2;
    CHECK(flash_text(outcome, FlashPurpose::write) ==
          std::string{heading} + "2 sectors written to the board at 1-2 and verified\n");
    outcome.differing.emplace();
    outcome.written = 0;
    CHECK(flash_text(outcome, FlashPurpose::write) ==
          std::string{heading} + "the board at 1-2 holds all of it already\n");
    outcome.drive = "/media/RPI-RP2";
    CHECK(flash_text(outcome, FlashPurpose::write) ==
          std::string{heading} + "copied to /media/RPI-RP2, which cannot be verified\n");
}

TEST_CASE("a dry run tells the places, neighbours together")
{
    FlashOutcome outcome = three_sectors();
    CHECK(flash_text(outcome, FlashPurpose::dry_run) ==
          std::string{heading} +
              "to be written: those that differ from what flash holds, which is not known\n"
              "  0x10000000, 2 sectors, 8192 bytes\n  0x10040000, 1 sector, 4096 bytes\n");
    outcome.differing = {0x1000'1000};
    CHECK(flash_text(outcome, FlashPurpose::dry_run) ==
          std::string{heading} + "to be written to the board at 1-2, as flash holds something else there: "
                                 "1 sector\n  0x10001000, 1 sector, 4096 bytes\n");
    outcome.differing.emplace();
    CHECK(flash_text(outcome, FlashPurpose::dry_run) ==
          std::string{heading} + "the board at 1-2 holds all of it already\n");
}

TEST_CASE("what was verified is told")
{
    CHECK(flash_text(three_sectors(), FlashPurpose::verify_only) ==
          std::string{heading} + "the board at 1-2 holds all of it\n");
}

TEST_CASE("what a player plays is told, and which slot it left")
{
    PlayerOutcome player = playing_built_in();
    CHECK(player_text(player) == "E66058388341A22C: plays the built-in scene, frame 0 of 60\n");
    player.left_slot = 2;
    CHECK(player_text(player) ==
          "E66058388341A22C: slot 2 was chosen to play; the built-in scene is chosen now\n"
          "E66058388341A22C: plays the built-in scene, frame 0 of 60\n");
}

TEST_CASE("programs are told all of it")
{
    FlashOutcome outcome = three_sectors();
    outcome.differing = {0x1004'0000};
    outcome.written = 2;
    outcome.verified = outcome.restarted = true;
    auto json = flash_json(outcome, playing_built_in());
    CHECK(json["port"] == "1-2");
    CHECK(json["drive"].is_null());
    CHECK(json["sectors"] == 3);
    CHECK(json["differing"].dump() == "[268697600]"); // 0x1004'0000
    CHECK(json["written"] == 2);
    CHECK(json["verified"] == true);
    CHECK(json["restarted"] == true);
    CHECK(json["serial"] == "E66058388341A22C");
    CHECK(json["left_slot"].is_null());
    CHECK(json["plays"]["home"] == "built-in");

    outcome.serial = "E7";
    json = flash_json(outcome, std::nullopt);
    CHECK(json["serial"] == "E7");
    CHECK(json["plays"].is_null());
}

}
