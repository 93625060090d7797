#include "host/text/utf8.hpp"

namespace kfast {
namespace {

void append_byte(std::string& text, char32_t byte) { text += static_cast<char>(byte); }

}

void append_utf8(std::string& text, char32_t value)
{
    if (value < 0x80)
        return append_byte(text, value);
    if (value < 0x800) {
        append_byte(text, 0xC0 | value >> 6);
    } else if (value < 0x10000) {
        append_byte(text, 0xE0 | value >> 12);
        append_byte(text, 0x80 | (value >> 6 & 0x3F));
    } else {
        append_byte(text, 0xF0 | value >> 18);
        append_byte(text, 0x80 | (value >> 12 & 0x3F));
        append_byte(text, 0x80 | (value >> 6 & 0x3F));
    }
    append_byte(text, 0x80 | (value & 0x3F));
}

}
