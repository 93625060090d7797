#include "host/kdl/string_literal.hpp"

#include "host/kdl/escape.hpp"
#include "host/kdl/multi_line_string.hpp"

#include <utility>

namespace kfast::kdl {

namespace {

std::string_view read_hashes(Scanner& scanner)
{
    const std::size_t begin = scanner.offset();
    while (scanner.accept("#")) {
    }
    return scanner.since(begin);
}

std::string hint_for_unclosed(std::size_t hashes)
{
    if (hashes == 0)
        return "add a closing \", or use \"\"\" for a text of several lines";
    return "add a closing \" with " + std::to_string(hashes) + " # after it";
}

/// After the opening quotes of a string that began at `begin`.
std::optional<StringLiteral> read_line_string(Scanner& scanner, std::size_t begin, std::string_view hashes)
{
    const SourceSpan opening = scanner.place_since(begin);
    const std::string closing = '"' + std::string(hashes);
    StringLiteral literal{.text = {}, .text_offset = scanner.offset()};
    bool is_valid = true;
    while (!scanner.accept(closing)) {
        if (scanner.at_end() || scanner.at_newline()) {
            scanner.error(opening, "this string is not closed on its line", hint_for_unclosed(hashes.size()));
            return {};
        }
        if (hashes.empty() && scanner.at("\\")) {
            is_valid = read_escape(scanner, literal.text) && is_valid;
            literal.text_offset.reset();
            continue;
        }
        const std::size_t point = scanner.offset();
        scanner.advance();
        literal.text += scanner.since(point);
    }
    return is_valid ? std::optional{std::move(literal)} : std::nullopt;
}

}

bool at_string_literal(const Scanner& scanner)
{
    Scanner ahead = scanner;
    read_hashes(ahead);
    return ahead.at("\"");
}

std::optional<StringLiteral> read_string_literal(Scanner& scanner)
{
    const std::size_t begin = scanner.offset();
    const std::string_view hashes = read_hashes(scanner);
    if (!scanner.accept("\"\"\"")) {
        scanner.advance();
        return read_line_string(scanner, begin, hashes);
    }
    std::optional<std::string> text = read_multi_line_string(scanner, begin, hashes);
    return text ? std::optional{StringLiteral{.text = std::move(*text), .text_offset = {}}} : std::nullopt;
}

}
