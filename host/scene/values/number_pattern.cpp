#include "host/scene/values/number_pattern.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::scene {
namespace {

constexpr std::u32string_view of_digits = U"#_0";
constexpr std::u32string_view of_decimals = U"#0";
constexpr std::u32string_view points = U".,";

constexpr auto hint = "write a digit as #, _ or 0, and what stands around it, as in \"##0.0 km/h\"";

/// Is added to a character between quotes, which stands for itself.
constexpr char32_t quoted = char32_t{1} << 31;

/// A format, and where in the text each of its characters begins.
struct Format {
    std::u32string characters;
    std::vector<std::size_t> offsets;
};

/// Two quotes are one, and a quote without a second one is itself.
Format characters_of(std::string_view text)
{
    constexpr char quote = '\'';
    Format format;
    bool is_quoted = false;
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view rest = text.substr(at + 1);
        const bool is_doubled = text[at] == quote && rest.starts_with(quote);
        if (text[at] == quote && !is_doubled && (is_quoted || rest.find(quote) != rest.npos)) {
            is_quoted = !is_quoted;
            ++at;
            continue;
        }
        const CodePoint point = code_point_at(text, at);
        format.characters += point.value | (is_quoted ? quoted : U'\0');
        format.offsets.push_back(at);
        at += point.length + (is_doubled ? 1 : 0);
    }
    return format;
}

std::u32string without_quotes(std::u32string_view text)
{
    std::u32string plain{text};
    for (char32_t& character : plain)
        character &= ~quoted;
    return plain;
}

bool has(std::u32string_view text, char32_t character) { return text.find(character) != text.npos; }

/// Takes as many characters in front of `text` as are among `known`.
std::u32string_view take(std::u32string_view& text, std::u32string_view known)
{
    const std::size_t count = std::min(text.find_first_not_of(known), text.size());
    const std::u32string_view taken = text.substr(0, count);
    text.remove_prefix(count);
    return taken;
}

/// Takes the point and the decimals. False if they are a group of thousands, as in "#,##0".
bool take_decimals(std::u32string_view& text, NumberPattern& pattern)
{
    if (text.size() < 2 || !has(points, text[0]) || !has(of_decimals, text[1]))
        return true;
    pattern.point = text[0];
    text.remove_prefix(1);
    const std::u32string_view decimals = take(text, of_decimals);
    pattern.decimals = static_cast<std::uint32_t>(decimals.size());
    return decimals.find(U"#0") == decimals.npos;
}

/// Where in what stands behind a number its digits begin again. A 0 of another number, as in "# of 100", is
/// itself.
std::size_t second_digits(std::u32string_view behind)
{
    bool is_in_number = false;
    for (std::size_t i = 0; i < behind.size(); ++i) {
        const char32_t character = behind[i];
        if (has(of_digits, character) && (character != U'0' || !is_in_number))
            return i;
        is_in_number = (character >= U'0' && character <= U'9') || (is_in_number && has(points, character));
    }
    return behind.npos;
}

bool is_line(std::u32string_view text)
{
    return std::ranges::none_of(text,
                                [](char32_t character) { return character < U' ' || character == 0x7F; });
}

class PatternReader {
public:
    PatternReader(const kdl::Value& value, std::string_view written, SceneContext& context)
        : value_{value}, format_{characters_of(written)}, context_{context}
    {
    }

    std::optional<NumberPattern> read()
    {
        NumberPattern pattern;
        const std::u32string_view all = format_.characters;
        std::u32string_view rest = all;
        const std::u32string_view before = rest.substr(0, rest.find_first_of(of_digits));
        rest.remove_prefix(before.size());
        const std::u32string_view digits = take(rest, of_digits);
        if (digits.empty())
            return refuse("this format has no digit");
        const auto zeros = static_cast<std::uint32_t>(std::ranges::count(digits, U'0'));
        if (has(digits.substr(0, digits.size() - zeros), U'0'))
            return refuse("# and _ stand in front of 0");
        pattern.digits = std::max(zeros, 1U);
        if (has(digits, U'_'))
            pattern.places = static_cast<std::uint32_t>(digits.size());
        const std::size_t point = all.size() - rest.size();
        if (!take_decimals(rest, pattern))
            return refuse_thousands(point);
        if (const std::size_t again = second_digits(rest); again != rest.npos)
            return refuse_second_digits(all.size() - rest.size() + again);
        pattern.before = without_quotes(before);
        pattern.behind = without_quotes(rest);
        if (digits.size() > kfb::max_digits || pattern.decimals > kfb::max_decimals)
            return refuse("a number has at most 10 digits before the point and 3 behind it");
        if (pattern.before.size() + pattern.behind.size() > kfb::max_around)
            return refuse("at most " + std::to_string(kfb::max_around) + " characters stand around a number");
        if (!is_line(without_quotes(all)))
            return refuse("a format is one line of visible characters");
        return pattern;
    }

private:
    std::nullopt_t refuse(std::string message)
    {
        context_.report.error(value_.place, std::move(message), hint);
        return std::nullopt;
    }

    std::nullopt_t refuse_thousands(std::size_t at)
    {
        context_.report.error(place_of(at), "there are no separators of thousands",
                              "write the digits together, as in \"###0\"; decimals are \"0.000\"");
        return std::nullopt;
    }

    std::nullopt_t refuse_second_digits(std::size_t at)
    {
        if (format_.characters[at - 1] == U',')
            return refuse_thousands(at - 1);
        context_.report.error(place_of(at), "a format has one number, and this is a digit of a second one",
                              "put what is shown as it is between quotes, as in \"#:'00'\"");
        return std::nullopt;
    }

    SourceSpan place_of(std::size_t character) const
    {
        return place_in_text(value_, {format_.offsets[character], 1});
    }

    const kdl::Value& value_;
    Format format_;
    SceneContext& context_;
};

}

std::optional<NumberPattern> read_number_pattern(const kdl::Value& value, SceneContext& context)
{
    const auto written = read_text(value, context.report);
    return written ? PatternReader{value, *written, context}.read() : std::nullopt;
}

}
