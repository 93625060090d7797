#include "host/import/content_kind.hpp"

#include "host/archive/archive.hpp"
#include "host/text/characters.hpp"

#include <algorithm>

namespace kfast::importing {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view space = " \t\r\n";
constexpr std::string_view utf_8_mark = "\xEF\xBB\xBF";

std::string_view without_mark(std::string_view text)
{
    return text.starts_with(utf_8_mark) ? text.substr(utf_8_mark.size()) : text;
}

std::string_view without_space(std::string_view text)
{
    return text.substr(std::min(text.find_first_not_of(space), text.size()));
}

std::string_view behind(std::string_view text, std::string_view end)
{
    const std::size_t at = text.find(end);
    return at == std::string_view::npos ? ""sv : text.substr(at + end.size());
}

/// A declaration of the document's type may hold others, in brackets.
std::string_view behind_declaration(std::string_view text)
{
    const std::size_t at = text.find_first_of("[>");
    if (at != std::string_view::npos && text[at] == '[')
        return behind(behind(text.substr(at), "]"), ">");
    return behind(text, ">");
}

/// What follows the first thing in a text that is no element; the text itself if that is one.
std::string_view behind_prolog(std::string_view text)
{
    if (text.starts_with("<?"))
        return behind(text, "?>");
    if (text.starts_with("<!--"))
        return behind(text, "-->");
    if (text.starts_with("<!"))
        return behind_declaration(text);
    return text;
}

}

std::optional<ContentKind> kind_of(std::string_view content)
{
    if (archive::is_gzip(content))
        return ContentKind::gzip;
    if (archive::is_zip(content))
        return ContentKind::zip;
    if (const char first = first_of_utf16(content); first == '<' || first == '{')
        return ContentKind::utf_16;
    const std::string_view text = without_space(without_mark(content));
    if (text.starts_with('{'))
        return ContentKind::json;
    if (text.starts_with('<'))
        return ContentKind::xml;
    return std::nullopt;
}

std::string_view root_element(std::string_view xml)
{
    std::string_view text = without_space(without_mark(xml));
    for (std::string_view rest = behind_prolog(text); rest.size() < text.size(); rest = behind_prolog(text))
        text = without_space(rest);
    if (!text.starts_with('<'))
        return "";
    const std::string_view name = text.substr(1, text.find_first_of(" \t\r\n/>", 1) - 1);
    return name.substr(name.find(':') + 1);
}

}
