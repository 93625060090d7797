#include "core/bytes/code_point.hpp"

#include "core/bytes/expects.hpp"

#include <array>

namespace kfast {
namespace {

struct SequenceForm {
    unsigned mask;
    unsigned lead;
    std::size_t length;
    char32_t lowest; ///< anything below is an overlong form
};

// The type is written out because g++ 12 keeps in RAM what it has deduced.
constexpr std::array<SequenceForm, 3> sequence_forms{
    SequenceForm{.mask = 0xE0, .lead = 0xC0, .length = 2, .lowest = 0x80},
    SequenceForm{.mask = 0xF0, .lead = 0xE0, .length = 3, .lowest = 0x800},
    SequenceForm{.mask = 0xF8, .lead = 0xF0, .length = 4, .lowest = 0x10000},
};

unsigned byte_at(std::string_view text, std::size_t offset)
{
    return static_cast<unsigned char>(text[offset]);
}

CodePoint sequence_at(std::string_view text, std::size_t offset, const SequenceForm& form)
{
    const CodePoint lone_byte{.value = byte_at(text, offset), .length = 1, .valid = false};
    if (text.size() - offset < form.length)
        return lone_byte;
    char32_t value = byte_at(text, offset) & ~form.mask & 0xFF;
    for (std::size_t i = 1; i < form.length; ++i) {
        if ((byte_at(text, offset + i) & 0xC0) != 0x80)
            return lone_byte;
        value = value << 6 | (byte_at(text, offset + i) & 0x3F);
    }
    if (value < form.lowest || !is_scalar_value(value))
        return lone_byte;
    return {.value = value, .length = form.length};
}

}

CodePoint code_point_at(std::string_view text, std::size_t offset)
{
    expects(offset < text.size());
    const unsigned first = byte_at(text, offset);
    if (first < 0x80)
        return {.value = first};
    for (const SequenceForm& form : sequence_forms)
        if ((first & form.mask) == form.lead)
            return sequence_at(text, offset, form);
    return {.value = first, .length = 1, .valid = false};
}

}
