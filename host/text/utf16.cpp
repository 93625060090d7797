#include "host/text/utf16.hpp"

namespace kfast {
namespace {

bool has_mark(std::string_view text) { return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"); }

bool begins_a_text(char character)
{
    return (character >= ' ' && character <= '~') || character == '\t' || character == '\n' ||
           character == '\r';
}

}

char first_of_utf16(std::string_view text)
{
    if (has_mark(text))
        text.remove_prefix(2);
    if (text.size() < 2 || (text[0] == '\0') == (text[1] == '\0'))
        return '\0';
    const char character = text[0] == '\0' ? text[1] : text[0];
    return begins_a_text(character) ? character : '\0';
}

bool seems_utf16(std::string_view text) { return has_mark(text) || first_of_utf16(text) != '\0'; }

}
