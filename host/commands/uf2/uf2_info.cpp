#include "host/commands/options/report_options.hpp"
#include "host/commands/text/json_text.hpp"
#include "host/commands/uf2/uf2_commands.hpp"
#include "host/commands/uf2/uf2_input.hpp"
#include "host/flash/hex_text.hpp"
#include "host/flash/uf2_family.hpp"
#include "host/text/counted.hpp"

#include <array>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

struct Uf2InfoOptions {
    std::string file;
    bool json = false;
};

struct BlockFlag {
    std::uint32_t bit;
    const char* name;
};

constexpr std::array flags{BlockFlag{0x0001, "not-for-flash"}, BlockFlag{0x1000, "stored-file"},
                           BlockFlag{0x2000, "family"}, BlockFlag{0x4000, "checksum"},
                           BlockFlag{0x8000, "tags"}};

std::vector<std::string> flag_names(std::uint32_t set)
{
    std::vector<std::string> names;
    for (const auto& [bit, name] : flags)
        if ((set & bit) != 0)
            names.emplace_back(name);
    return names;
}

std::size_t bytes_of(const Uf2Part& part)
{
    std::size_t bytes = 0;
    for (const FlashRegion& region : part.regions)
        bytes += region.bytes.size();
    return bytes;
}

void print_part(const Uf2Part& part)
{
    std::cout << "  for " << chips_of(part) << ": " << counted(part.blocks, "block") << ", "
              << counted(bytes_of(part), "byte");
    for (const std::string& name : flag_names(part.flags))
        std::cout << (name == "family" ? "" : ", " + name);
    std::cout << '\n';
    for (const auto& [region, words] : pieces_of(part))
        std::cout << "    " << hex_text(region.address) << "  " << counted(region.bytes.size(), "byte")
                  << (words.empty() ? "" : "  " + words) << '\n';
}

/// Null if nobody knows.
Json words_json(std::string_view words) { return words.empty() ? Json(nullptr) : Json(words); }

Json json_of(const Uf2Part& part)
{
    Json regions = Json::array();
    for (const auto& [region, words] : pieces_of(part))
        regions.push_back(
            {{"address", region.address}, {"bytes", region.bytes.size()}, {"holds", words_json(words)}});
    return {{"family", part.family ? Json(*part.family) : Json(nullptr)},
            {"chips", words_json(part.family ? uf2_family_name(*part.family) : "")},
            {"flags", flag_names(part.flags)},
            {"blocks", part.blocks},
            {"bytes", bytes_of(part)},
            {"regions", regions}};
}

void inform(const Uf2InfoOptions& options)
{
    const Uf2Contents contents = load_uf2(options.file);
    if (options.json) {
        Json parts = Json::array();
        for (const Uf2Part& part : contents.parts)
            parts.push_back(json_of(part));
        std::cout << json_text({{"file", options.file}, {"blocks", contents.blocks}, {"parts", parts}});
        return;
    }
    std::cout << options.file << ": " << counted(contents.blocks, "block") << '\n';
    for (const Uf2Part& part : contents.parts)
        print_part(part);
}

}

void declare_uf2_info(CLI::App& app)
{
    const auto options = std::make_shared<Uf2InfoOptions>();
    app.add_option("FILE", options->file, "A UF2 file")->required();
    declare_json(app, options->json);
    app.footer("Example:\n  kfast uf2 info eyes.uf2");
    app.callback([options] { inform(*options); });
}

}
