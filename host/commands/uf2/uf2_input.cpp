#include "host/commands/uf2/uf2_input.hpp"

#include "host/file/input_file.hpp"
#include "host/flash/hex_text.hpp"
#include "host/flash/uf2.hpp"
#include "host/flash/uf2_family.hpp"
#include "host/program/failure.hpp"
#include "host/text/counted.hpp"

#include <algorithm>

namespace kfast {
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
