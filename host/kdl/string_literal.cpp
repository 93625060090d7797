#include "host/kdl/string_literal.hpp"

#include "host/kdl/escape.hpp"
#include "host/kdl/scanner.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::kdl {

namespace {

struct TextLine {
    std::size_t offset = 0; ///< where it begins in the source
    std::string text = {};
    std::size_t indent = 0; ///< how many spaces `text` begins with that are no escapes

    bool is_blank() const { return indent == text.size(); }
};

/// The lines between the quotes, with their indentation; the last is the one with the closing quotes.
struct Block {
    std::vector<TextLine> lines;
    SourceSpan closing;
};

void read_point(Scanner& scanner, TextLine& line)
{
    const std::size_t begin = scanner.offset();
    const bool indents = scanner.at_space() && line.is_blank();
    scanner.advance();
    line.text += scanner.since(begin);
    if (indents)
        line.indent = line.text.size();
}

std::optional<Block> read_block(Scanner& scanner, SourceSpan opening, std::string_view hashes)
{
    const std::string closing = "\"\"\"" + std::string(hashes);
    Block block{.lines = {TextLine{.offset = scanner.offset()}}, .closing = {}};
    bool is_valid = true;
    while (!scanner.at(closing)) {
        if (scanner.at_end()) {
            scanner.error(opening, "this string is not closed",
                          "add a closing \"\"\" on a line of its own, with as many # after it as before");
            scanner.stop();
            return {};
        }
        if (scanner.accept_newline())
            block.lines.push_back({.offset = scanner.offset()});
        else if (hashes.empty() && scanner.at("\\"))
            is_valid = read_escape(scanner, block.lines.back().text) && is_valid;
        else
            read_point(scanner, block.lines.back());
    }
    const std::size_t end = scanner.offset();
    scanner.accept(closing);
    block.closing = scanner.place_since(end);
    return is_valid ? std::optional{std::move(block)} : std::nullopt;
}

bool shares_indent(const TextLine& line, const std::string& indent)
{
    return line.is_blank() || (line.indent >= indent.size() && line.text.starts_with(indent));
}

std::string without_indent(const std::vector<TextLine>& lines)
{
    const std::size_t indent = lines.back().text.size();
    std::string text;
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
        text += i > 0 ? "\n" : "";
        text += lines[i].is_blank() ? "" : std::string_view{lines[i].text}.substr(indent);
    }
    return text;
}

/// After the opening """ of a string that began at `begin` with `hashes` (none if it is not raw): goes over
/// it and returns its text without the indentation that all lines share. Errors are reported and leave
/// nothing.
std::optional<std::string> read_multi_line_string(Scanner& scanner, std::size_t begin,
                                                  std::string_view hashes)
{
    const SourceSpan opening = scanner.place_since(begin);
    if (!scanner.accept_newline())
        scanner.error(opening, "text follows the opening \"\"\" on its line",
                      "begin a new line after it, or use \" for a text of one line");
    const std::optional<Block> block = read_block(scanner, opening, hashes);
    if (!block)
        return {};
    const std::vector<TextLine>& lines = block->lines;
    if (!lines.back().is_blank()) {
        scanner.error(block->closing, "text stands before the closing \"\"\"", "put it on a line of its own");
        return {};
    }
    for (const TextLine& line : lines)
        if (!shares_indent(line, lines.back().text)) {
            scanner.error({.offset = line.offset, .length = line.indent},
                          "this line does not begin with the spaces of the closing line",
                          "begin it with the very spaces and tabs that stand before the closing \"\"\"");
            return {};
        }
    return without_indent(lines);
}

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
