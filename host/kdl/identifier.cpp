#include "host/kdl/identifier.hpp"

#include "host/kdl/code_point_class.hpp"
#include "host/text/utf8.hpp"

#include <algorithm>
#include <array>

namespace kfast::kdl {

namespace {

constexpr std::array<std::string_view, 6> reserved_words{"true", "false", "null", "inf", "-inf", "nan"};

void drop_first_of(std::string_view& word, std::string_view characters)
{
    if (!word.empty() && characters.find(word.front()) != characters.npos)
        word.remove_prefix(1);
}

bool may_stand_bare(CodePoint point)
{
    return point.valid && is_identifier_character(point.value) && !is_disallowed(point.value);
}

}

bool is_reserved(std::string_view word)
{
    return std::ranges::find(reserved_words, word) != reserved_words.end();
}

bool begins_like_number(std::string_view word)
{
    drop_first_of(word, "+-");
    drop_first_of(word, ".");
    return !word.empty() && word.front() >= '0' && word.front() <= '9';
}

bool is_identifier(std::string_view text)
{
    for (std::size_t at = 0; at < text.size(); at += code_point_at(text, at).length)
        if (!may_stand_bare(code_point_at(text, at)))
            return false;
    return !text.empty() && !is_reserved(text) && !begins_like_number(text);
}

}
