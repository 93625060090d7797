#include "host/commands/uf2/uf2_input.hpp"

#include "core/bytes/byte_reader.hpp"
#include "core/scene/scene_view.hpp"
#include "firmware/settings/board_record.hpp"
#include "firmware/settings/image_mark.hpp"
#include "host/commands/text/summary.hpp"
#include "host/config/firmware_images.hpp"
#include "host/config/pico_flash.hpp"
#include "host/config/setting_words.hpp"
#include "host/file/input_file.hpp"
#include "host/flash/flash_image.hpp"
#include "host/flash/uf2.hpp"
#include "host/flash/uf2_family.hpp"
#include "host/program/failure.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace kfast {

namespace {

using Bytes = std::span<const std::byte>;

/// What begins a piece.
struct Known {
    std::size_t bytes;
    std::string words;
};

std::optional<Known> known_firmware(Bytes bytes)
{
    if (!config::begins_with_boot_block(bytes))
        return std::nullopt;
    const auto bus = config::marked_bus(bytes);
    if (!bus || bytes.size() < ImageMark::length_place + 4)
        return Known{bytes.size(), "a program that begins with a boot block"};
    ByteReader length{bytes.subspan(ImageMark::length_place)};
    return Known{std::min<std::size_t>(length.u32(), bytes.size()),
                 "firmware for displays on " + config::word_of(*bus)};
}

/// "a display st7789, 240 x 320, on spi"
std::string settings_text(const BoardSettings& settings)
{
    const std::string bus = ", on " + config::word_of(settings.bus);
    if (leads_beam(settings.bus))
        return "a beam, " + std::to_string(settings.beam.rate) + " points a second" + bus;
    return "a display " + config::word_of(settings.panel.controller) + ", " +
           config::size_text(settings.panel.glass) + bus;
}

std::optional<Known> known_settings(Bytes bytes)
{
    const auto settings = read_board_record(bytes);
    if (!settings)
        return std::nullopt;
    return Known{std::min(pico_flash::sector_bytes, bytes.size()), "settings of " + settings_text(*settings)};
}

std::optional<Known> known_scene(Bytes bytes)
{
    const auto scene = SceneView::parse(bytes);
    if (!scene)
        return std::nullopt;
    const Bytes own = bytes.first(scene->size());
    return Known{own.size(), "scene: " + summary(SceneFile{{own.begin(), own.end()}, *scene})};
}

struct KnownPlace {
    std::uint32_t address;
    std::optional<Known> (*look)(Bytes);
};

constexpr std::array places{KnownPlace{pico_flash::begin, known_firmware},
                            KnownPlace{pico_flash::settings, known_settings},
                            KnownPlace{pico_flash::scene, known_scene}};

/// From `begin` to `end`, which are in the region.
FlashPiece piece_of(const FlashRegion& region, std::uint64_t begin, std::uint64_t end)
{
    Bytes bytes = Bytes{region.bytes}.subspan(begin - region.address, end - begin);
    const auto* const place = std::ranges::find(places, begin, &KnownPlace::address);
    const auto known = place == places.end() ? std::nullopt : place->look(bytes);
    if (known)
        bytes = bytes.first(known->bytes);
    return {{static_cast<std::uint32_t>(begin), {bytes.begin(), bytes.end()}}, known ? known->words : ""};
}

/// Whether something that is known begins there, inside of the region.
bool begins_something(const FlashRegion& region, const KnownPlace& place)
{
    const std::uint64_t end = std::uint64_t{region.address} + region.bytes.size();
    return place.address > region.address && place.address < end &&
           place.look(Bytes{region.bytes}.subspan(place.address - region.address)).has_value();
}

}

std::vector<FlashPiece> flash_pieces(std::span<const FlashRegion> regions)
{
    std::vector<FlashPiece> pieces;
    for (const FlashRegion& region : regions) {
        std::uint64_t begin = region.address;
        for (const KnownPlace& place : places)
            if (begins_something(region, place)) {
                pieces.push_back(piece_of(region, begin, place.address));
                begin = place.address;
            }
        pieces.push_back(piece_of(region, begin, std::uint64_t{region.address} + region.bytes.size()));
    }
    return pieces;
}

namespace {

constexpr InputKind uf2_input{"UF2 file", "a .uf2 file", "copy it again"};
constexpr std::size_t max_mistakes = 20; ///< that are reported one by one

std::string mistakes_text(const std::vector<Uf2Mistake>& mistakes)
{
    std::string text;
    for (std::size_t at = 0; at < std::min(mistakes.size(), max_mistakes); ++at)
        text += "\n  block " + std::to_string(mistakes[at].block) + ": " + mistakes[at].reason;
    if (mistakes.size() > max_mistakes)
        text += "\n  and " + std::to_string(mistakes.size() - max_mistakes) + " more";
    return text;
}

}

Uf2Contents load_uf2(const std::filesystem::path& path)
{
    const std::string file = read_input(path, uf2_input);
    Uf2Contents contents = read_uf2(std::as_bytes(std::span{file}));
    if (!contents.mistakes.empty())
        throw Failure{path.string() + ": " + counted(contents.mistakes.size(), "mistake") + " in " +
                      counted(contents.blocks, "block") + ": copy the file again, or make it again" +
                      mistakes_text(contents.mistakes)};
    return contents;
}

std::string chips_of(const Uf2Part& part)
{
    if (!part.family)
        return "unknown chips";
    const std::string_view name = uf2_family_name(*part.family);
    const std::string number = hex_text(*part.family);
    return name.empty() ? number : std::string{name} + " (" + number + ")";
}

std::vector<FlashPiece> pieces_of(const Uf2Part& part)
{
    if (part.family == rp2040_family)
        return flash_pieces(part.regions);
    std::vector<FlashPiece> pieces;
    for (const FlashRegion& region : part.regions)
        pieces.push_back({region, ""});
    return pieces;
}

}
