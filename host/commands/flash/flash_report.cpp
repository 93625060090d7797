#include "host/commands/flash/flash_report.hpp"

#include "host/commands/devices/playing_text.hpp"
#include "host/flash/hex_text.hpp"
#include "host/text/counted.hpp"
#include "host/text/glyph.hpp"

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

/// A line for each run of neighbours: "  0x10040000, 2 sectors, 8192 bytes".
std::string sector_lines(const std::vector<std::uint32_t>& addresses)
{
    std::string lines;
    for (std::size_t begin = 0, end = 0; begin < addresses.size(); begin = end) {
        for (end = begin + 1; end < addresses.size(); ++end)
            if (addresses[end] != addresses[end - 1] + FlashImage::sector_bytes)
                break;
        lines += "  " + hex_text(addresses[begin]) + ", " + counted(end - begin, "sector") + ", " +
                 std::to_string((end - begin) * FlashImage::sector_bytes) + " bytes\n";
    }
    return lines;
}

std::string place_words(const FlashOutcome& outcome)
{
    if (!outcome.drive.empty())
        return visible(outcome.drive);
    return outcome.port.empty() ? "" : "the board at " + visible(outcome.port);
}

std::string holds_all(const FlashOutcome& outcome)
{
    return place_words(outcome) + " holds all of it already\n";
}

std::string dry_text(const FlashOutcome& outcome)
{
    if (outcome.differing && outcome.differing->empty())
        return holds_all(outcome);
    if (outcome.differing)
        return "to be written to " + place_words(outcome) +
               ", as flash holds something else there: " + counted(outcome.differing->size(), "sector") +
               '\n' + sector_lines(*outcome.differing);
    return "to be written" + (outcome.drive.empty() ? "" : " to " + place_words(outcome)) +
           ": those that differ from what flash holds, which is not known\n" +
           sector_lines(outcome.addresses);
}

std::string written_text(const FlashOutcome& outcome)
{
    if (!outcome.drive.empty())
        return "copied to " + place_words(outcome) + ", which cannot be verified\n";
    if (outcome.written == 0)
        return holds_all(outcome);
    return counted(outcome.written, "sector") + " written to " + place_words(outcome) + " and verified\n";
}

}

std::string flash_text(const FlashOutcome& outcome, FlashPurpose purpose)
{
    const std::string contents = outcome.contents + ": " + counted(outcome.addresses.size(), "sector") + '\n';
    switch (purpose) {
    case FlashPurpose::write:
        return contents + written_text(outcome);
    case FlashPurpose::dry_run:
        return contents + dry_text(outcome);
    case FlashPurpose::verify_only:
        return contents + place_words(outcome) + " holds all of it\n";
    }
    return {};
}

std::string player_text(const PlayerOutcome& player)
{
    std::string text;
    if (player.left_slot)
        text = player.name + ": slot " + std::to_string(int{*player.left_slot}) +
               " was chosen to play; the built-in scene is chosen now\n";
    return text + player.name + ": plays " + playing_text(player.playing) + '\n';
}

Json flash_json(const FlashOutcome& outcome, const std::optional<PlayerOutcome>& player)
{
    const auto or_null = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
    return {
        {"board", "pico"},
        {"contents", outcome.contents},
        {"port", or_null(outcome.port)},
        {"drive", or_null(outcome.drive)},
        {"sectors", outcome.addresses.size()},
        {"differing", outcome.differing ? Json(*outcome.differing) : Json()},
        {"written", outcome.written},
        {"verified", outcome.verified},
        {"restarted", outcome.restarted},
        {"serial", player ? Json(player->name) : or_null(outcome.serial)},
        {"left_slot", player && player->left_slot ? Json(*player->left_slot) : Json()},
        {"plays", player ? playing_json(player->playing) : Json()},
    };
}

}
