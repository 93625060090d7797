#include "host/lottie/values/loops.hpp"

#include "host/lottie/values/json.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <regex>
#include <string>

namespace kfast::lottie {
namespace {

/// Players take the kind of a loop in any case.
std::string in_lower_case(std::string word)
{
    std::ranges::transform(word, word.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return word;
}

}

std::optional<PropertyLoop> read_loop(const Json& property)
{
    constexpr std::size_t max_length = 200; // what is longer is another expression
    // As After Effects' exporter writes it: "var $bm_rt;\n$bm_rt = loopOut('cycle', 0);"
    static const std::regex form{
        R"(\s*(?:var\s+\$bm_rt\s*;)?\s*(?:\$bm_rt\s*=)?\s*(?:thisProperty\s*\.\s*)?loop(Out|In)\s*\(\s*)"
        R"((?:(['"])([A-Za-z]+)\2\s*(?:,\s*(\d{1,6})\s*)?)?\)\s*;?\s*)"};
    const Json* const text = property.is_object() ? find_member(property, "x") : nullptr;
    if (text == nullptr || !text->is_string())
        return std::nullopt;
    const auto& expression = text->get_ref<const std::string&>();
    std::smatch found;
    if (expression.size() > max_length || !std::regex_match(expression, found, form))
        return std::nullopt;
    const std::string kind = in_lower_case(found[3]);
    if (!kind.empty() && kind != "cycle" && kind != "pingpong")
        return std::nullopt;
    PropertyLoop loop{.is_out = found[1] == "Out", .turns_back = kind == "pingpong"};
    const std::string segments = found[4];
    std::from_chars(segments.data(), segments.data() + segments.size(), loop.segments);
    return loop;
}

}
