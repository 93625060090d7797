#include "host/config/config_input.hpp"

#include "firmware/settings/board_record.hpp"
#include "host/config/config_text.hpp"
#include "host/config/configurations.hpp"
#include "host/config/mistake_text.hpp"
#include "host/config/pico_flash.hpp"
#include "host/file/input_file.hpp"
#include "host/flash/uf2.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/text/reported_diagnostics.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <stdexcept>
#include <string_view>

namespace kfast::config {
namespace {

using Bytes = std::span<const std::byte>;

constexpr InputKind config_input{"configuration", "a .kdl, .bin or .uf2 file",
                                 "settings begin with 'board pico'"};
constexpr std::string_view record_magic = "KFBS";
constexpr std::size_t settings_offset = pico_flash::settings - pico_flash::begin;

BoardSettings from_text(const SourceText& source)
{
    Diagnostics diagnostics;
    const auto settings = read_config(source, diagnostics);
    const std::size_t errors = report(diagnostics, source).errors;
    if (!settings)
        throw Failure(source.name + ": " + counted(errors, "error"));
    return *settings;
}

BoardSettings from_configuration(const Configuration& configuration)
{
    Diagnostics unheard; // a warning of a clock that many use would not help who chose the configuration
    return *read_config({std::string{configuration.name}, std::string{configuration.text}}, unheard);
}

BoardSettings built_in(const std::string& name)
{
    const auto configuration = std::ranges::find(configurations(), name, &Configuration::name);
    if (configuration != configurations().end())
        return from_configuration(*configuration);
    std::vector<std::string_view> known;
    std::ranges::transform(configurations(), std::back_inserter(known), &Configuration::name);
    throw Failure("there is no configuration " + in_quotes(name) + ": " + suggestion(name, known) +
                  ", or name a file, like gadget.kdl");
}

void require_rules(const std::string& name, const BoardSettings& settings)
{
    const std::vector<SettingsMistake> found = mistakes(settings);
    if (found.empty())
        return;
    std::string text = name + ": settings that a Pico cannot follow: make them again from a text";
    for (const SettingsMistake& mistake : found) {
        const Finding finding = text_of(mistake, settings);
        text += "\n  " + finding.message + ": " + finding.hint;
    }
    throw Failure(text);
}

BoardSettings from_record(const std::string& name, Bytes bytes)
{
    const auto settings = read_board_record(bytes);
    if (!settings)
        throw Failure(name +
                      ": the settings in it are damaged, or of another version of kfast: make them again "
                      "with kfast config");
    require_rules(name, *settings);
    return *settings;
}

bool begins_with(Bytes bytes, std::string_view magic)
{
    const Bytes wanted = std::as_bytes(std::span{magic});
    return bytes.size() >= wanted.size() && std::ranges::equal(bytes.first(wanted.size()), wanted);
}

std::vector<FlashRegion> uf2_regions(const std::string& name, Bytes file)
{
    try {
        return regions_of(file);
    } catch (const std::invalid_argument& reason) {
        throw Failure(name + ": not a UF2 file for a Pico: " + reason.what() +
                      "; copy it again, or make it again with kfast uf2 pack");
    }
}

/// What a UF2 file writes from the address of the settings on; empty if it does not write them.
std::vector<std::byte> settings_in_uf2(const std::string& name, Bytes file)
{
    for (const FlashRegion& region : uf2_regions(name, file)) {
        const std::size_t offset = pico_flash::settings - region.address;
        if (region.address <= pico_flash::settings && offset < region.bytes.size())
            return {region.bytes.begin() + static_cast<std::ptrdiff_t>(offset), region.bytes.end()};
    }
    return {};
}

BoardSettings from_flash(const std::string& name, Bytes bytes)
{
    if (!begins_with(bytes, record_magic))
        throw Failure(name + ": there are no settings in it, neither at its beginning nor in their place in "
                             "flash (0x1003F000): add some with kfast uf2 pack --config");
    return from_record(name, bytes);
}

BoardSettings from_bytes(const std::string& name, Bytes bytes)
{
    if (begins_with(bytes, uf2_magic))
        return from_flash(name, settings_in_uf2(name, bytes));
    if (begins_with(bytes, record_magic))
        return from_record(name, bytes);
    return from_flash(name, bytes.size() > settings_offset ? bytes.subspan(settings_offset) : Bytes{});
}

/// Erased flash is 0xFF, which does not occur in UTF-8.
bool is_text(std::string_view content)
{
    return content.find_first_of(std::string_view{"\0\xFF", 2}) == content.npos &&
           !content.starts_with(record_magic) && !content.starts_with(uf2_magic);
}

BoardSettings from_file(const std::string& name)
{
    std::string content = read_input(name, config_input);
    return is_text(content) ? from_text({name, std::move(content)})
                            : from_bytes(name, std::as_bytes(std::span{content}));
}

}

BoardSettings chosen_settings(const std::string& input)
{
    return input.find_first_of("./") == input.npos ? built_in(input) : from_file(input);
}

std::vector<std::byte> settings_sector(const BoardSettings& settings)
{
    std::vector<std::byte> sector(pico_flash::sector_bytes, std::byte{0xFF});
    std::ranges::copy(board_record(settings), sector.begin());
    return sector;
}

}
