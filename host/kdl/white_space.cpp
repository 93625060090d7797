#include "host/kdl/white_space.hpp"

namespace kfast::kdl {

namespace {

void skip_to_line_end(Scanner& scanner)
{
    while (!scanner.at_end() && !scanner.at_newline())
        scanner.advance();
}

/// At /*. Comments nest, so that a stretch with comments can be commented out.
void skip_block_comment(Scanner& scanner)
{
    const std::size_t begin = scanner.offset();
    std::size_t depth = 0;
    do {
        if (scanner.accept("/*")) {
            ++depth;
        } else if (scanner.accept("*/")) {
            --depth;
        } else if (!scanner.at_end()) {
            scanner.advance();
        } else {
            scanner.error({.offset = begin, .length = 2}, "this comment is not closed", "add a closing */");
            return scanner.stop();
        }
    } while (depth > 0);
}

bool accept_block_comment(Scanner& scanner)
{
    if (!scanner.at("/*"))
        return false;
    skip_block_comment(scanner);
    return true;
}

bool accept_space(Scanner& scanner)
{
    if (!scanner.at_space())
        return accept_block_comment(scanner);
    scanner.advance();
    return true;
}

bool accept_line_continuation(Scanner& scanner)
{
    const std::size_t begin = scanner.offset();
    if (!scanner.accept("\\"))
        return false;
    while (accept_space(scanner)) {
    }
    if (scanner.at("//"))
        skip_to_line_end(scanner);
    if (!scanner.accept_newline() && !scanner.at_end())
        scanner.error(
            {.offset = begin, .length = 1}, "more follows on the line after this \\",
            "a \\ joins two lines: put it at the end of its line, or use quotes for a text with a \\");
    return true;
}

bool accept_node_space(Scanner& scanner)
{
    return accept_space(scanner) || accept_line_continuation(scanner);
}

bool accept_line_comment(Scanner& scanner)
{
    if (!scanner.at("//"))
        return false;
    skip_to_line_end(scanner);
    return true;
}

}

void skip_node_space(Scanner& scanner)
{
    while (accept_node_space(scanner)) {
    }
}

void skip_line_space(Scanner& scanner)
{
    while (accept_node_space(scanner) || scanner.accept_newline() || accept_line_comment(scanner)) {
    }
}

void skip_spaces(Scanner& scanner)
{
    while (scanner.at_space())
        scanner.advance();
}

}
