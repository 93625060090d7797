#include "host/kdl/scalar.hpp"

#include "host/kdl/number.hpp"
#include "host/kdl/scanner.hpp"
#include "host/kdl/string_literal.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

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

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool at_word(const Scanner& scanner) { return is_identifier_character(scanner.peek()); }

std::string_view read_word(Scanner& scanner)
{
    const std::size_t begin = scanner.offset();
    while (at_word(scanner))
        scanner.advance();
    return scanner.since(begin);
}

bool read_string(Scanner& scanner, Value& value)
{
    std::optional<StringLiteral> literal = read_string_literal(scanner);
    if (!literal)
        return false;
    value.data = std::move(literal->text);
    value.text_offset = literal->text_offset;
    return true;
}

struct Keyword {
    std::string_view word;
    decltype(Value::data) data;
};

bool read_keyword(Scanner& scanner, Value& value)
{
    const std::array keywords{
        Keyword{"#true", true},
        Keyword{"#false", false},
        Keyword{"#null", Null{}},
        Keyword{"#inf", Number{.canonical = "#inf", .value = infinity}},
        Keyword{"#-inf", Number{.canonical = "#-inf", .value = -infinity}},
        Keyword{"#nan", Number{.canonical = "#nan", .value = std::numeric_limits<double>::quiet_NaN()}},
    };
    const std::size_t begin = scanner.offset();
    while (scanner.accept("#")) {
    }
    read_word(scanner);
    for (const auto& [word, data] : keywords)
        if (word == scanner.since(begin)) {
            value.data = data;
            return true;
        }
    scanner.error(scanner.place_since(begin), in_quotes(scanner.since(begin)) + " is not a keyword",
                  "a text with a # needs quotes: \"" + std::string{scanner.since(begin)} +
                      "\"; the keywords are #true, #false, #null, #inf, #-inf and #nan");
    return false;
}

bool read_number(Scanner& scanner, std::size_t begin, Value& value)
{
    std::variant<Number, NumberFault> number = number_from(scanner.since(begin));
    if (auto* fault = std::get_if<NumberFault>(&number)) {
        scanner.error(scanner.place_since(begin), std::move(fault->message), std::move(fault->hint));
        return false;
    }
    value.data = std::get<Number>(std::move(number));
    return true;
}

/// Word processors and web pages put these in place of ".
void warn_of_typographic_quote(Scanner& scanner, std::size_t begin)
{
    constexpr std::array<std::string_view, 6> quotes{"\u201C", "\u201D", "\u201E",
                                                     "\u2018", "\u2019", "\u00AB"};
    for (const std::string_view quote : quotes)
        if (scanner.since(begin).starts_with(quote))
            scanner.warning({.offset = begin, .length = quote.size()},
                            std::string{quote} + " is read as a letter", "write \" around a text");
}

bool read_bare_word(Scanner& scanner, Value& value)
{
    const std::size_t begin = scanner.offset();
    const std::string word{read_word(scanner)};
    warn_of_typographic_quote(scanner, begin);
    if (begins_like_number(word))
        return read_number(scanner, begin, value);
    if (is_reserved(word)) {
        scanner.error(scanner.place_since(begin), '"' + word + "\" is not a value",
                      "write #" + word + ", or \"" + word + "\" for a text");
        return false;
    }
    if (word == "r" && at_string_literal(scanner)) {
        scanner.error(scanner.place_since(begin), "a raw string does not begin with r",
                      "write #\"...\"#, as KDL 2.0 does");
        return false;
    }
    value.data = word;
    value.text_offset = begin;
    return true;
}

}

bool at_scalar(const Scanner& scanner) { return scanner.at("\"") || scanner.at("#") || at_word(scanner); }

bool read_scalar(Scanner& scanner, Value& value)
{
    if (at_string_literal(scanner))
        return read_string(scanner, value);
    if (scanner.at("#"))
        return read_keyword(scanner, value);
    return read_bare_word(scanner, value);
}

}
