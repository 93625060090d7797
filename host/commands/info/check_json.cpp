#include "host/commands/info/check_json.hpp"

#include "host/commands/text/json_text.hpp"
#include "host/text/source.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

Json place_of(const Places& places, std::size_t offset)
{
    const LineColumn at = places.line_column(offset);
    return {{"line", at.line}, {"column", at.column}};
}

/// As in the Language Server Protocol: lines and UTF-16 code units from 0.
Json position_of(const Places& places, std::size_t offset)
{
    return {{"line", places.line_column(offset).line - 1}, {"character", places.code_units(offset)}};
}

Json json_of(const Diagnostic& diagnostic, std::string_view text, const Places& places)
{
    const std::size_t begin = std::min(diagnostic.place.offset, text.size());
    const std::size_t end = std::min(begin + diagnostic.place.length, text.size());
    return {{"severity", diagnostic.severity == Severity::error ? "error" : "warning"},
            {"message", diagnostic.message},
            {"remedy", diagnostic.hint},
            {"begin", place_of(places, begin)},
            {"end", place_of(places, end)},
            {"range", {{"start", position_of(places, begin)}, {"end", position_of(places, end)}}},
            {"bytes", {{"offset", begin}, {"length", end - begin}}}};
}

Json json_of(const art::Loss& loss)
{
    return {{"feature", loss.feature},
            {"layer", loss.layer},
            {"frame", loss.time ? Json(*loss.time) : Json{}},
            {"instead", loss.instead}};
}

Json json_of(const CheckedFile& file)
{
    const Places places{file.text};
    Json diagnostics = Json::array();
    for (const Diagnostic& diagnostic : file.diagnostics.sorted())
        diagnostics.push_back(json_of(diagnostic, file.text, places));
    Json losses = Json::array();
    for (const art::Loss& loss : file.losses.list())
        losses.push_back(json_of(loss));
    return {{"file", file.name},
            {"good", file.is_valid()},
            {"summary", file.summary},
            {"failure", file.failure},
            {"diagnostics", std::move(diagnostics)},
            {"losses", std::move(losses)},
            {"further_losses", file.losses.beyond()}};
}

}

std::string check_json(std::span<const CheckedFile> files)
{
    Json list = Json::array();
    for (const CheckedFile& file : files)
        list.push_back(json_of(file));
    return json_text({{"files", std::move(list)}});
}

}
