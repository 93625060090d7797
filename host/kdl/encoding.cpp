#include "host/kdl/encoding.hpp"

#include "host/kdl/code_point_class.hpp"
#include "host/text/glyph.hpp"
#include "host/text/utf8.hpp"

namespace kfast::kdl {

namespace {

void report_bad_byte(Scanner& scanner, std::size_t at)
{
    const std::string shown = visible(scanner.text().substr(at, 1));
    scanner.error({.offset = at, .length = 1}, "the byte " + shown + " is not UTF-8",
                  "save the text in the encoding UTF-8");
}

void report_disallowed(Scanner& scanner, std::size_t at, CodePoint point)
{
    const std::string shown = visible(scanner.text().substr(at, point.length));
    scanner.error({.offset = at, .length = point.length},
                  "the character " + shown + " may not stand in a text",
                  "remove it; in a string between quotes it can be written like \\u{7F}");
    scanner.silence(false);
}

}

bool check_encoding(Scanner& scanner)
{
    scanner.accept("\uFEFF");
    bool in_run = false; // a run of disallowed code points is one error
    for (std::size_t at = scanner.offset(); at < scanner.text().size();) {
        const CodePoint point = code_point_at(scanner.text(), at);
        if (!point.valid) {
            report_bad_byte(scanner, at);
            return false;
        }
        if (is_disallowed(point.value) && !in_run)
            report_disallowed(scanner, at, point);
        in_run = is_disallowed(point.value);
        at += point.length;
    }
    return true;
}

}
