#include "host/beam/ilda_writer.hpp"

#include "host/beam/ilda_format.hpp"

#include <cstdint>

namespace kfast {
namespace {

constexpr std::string_view company = "KFAST";

class IldaWriter {
public:
    IldaWriter(std::string_view name, IldaFormat format, std::size_t frames)
        : name_{name}, format_{format}, frames_{frames}
    {
    }

    void palette(std::span<const Colour> colours)
    {
        header(IldaFormat::palette, colours.size(), 0);
        for (const auto [red, green, blue, opacity] : colours) {
            u8(red);
            u8(green);
            u8(blue);
        }
    }

    void frame(std::span<const BeamPoint> points, std::size_t number, const IldaPalette& palette)
    {
        header(format_, points.size(), number);
        for (const BeamPoint& point : points) {
            place(point.at);
            u8((point.is_lit() ? 0 : ilda_blanked) | (&point == &points.back() ? ilda_last_point : 0));
            colour(point, palette);
        }
    }

    /// The end mark: a section without records.
    std::vector<std::byte> end()
    {
        header(format_, 0, frames_);
        return std::move(bytes_);
    }

private:
    void u8(int value) { bytes_.push_back(static_cast<std::byte>(value)); }

    void u16(std::size_t value)
    {
        u8(static_cast<int>(value >> 8 & 0xFF));
        u8(static_cast<int>(value & 0xFF));
    }

    void header(IldaFormat format, std::size_t records, std::size_t number)
    {
        for (const char letter : ilda_magic)
            u8(letter);
        bytes_.insert(bytes_.end(), 3, std::byte{}); // reserved
        u8(static_cast<int>(format));
        text(name_);
        text(company);
        u16(records);
        u16(number);
        u16(format == IldaFormat::palette ? 0 : frames_);
        u16(0); // the projector, and a byte that is reserved
    }

    void text(std::string_view text)
    {
        for (std::size_t at = 0; at < ilda_name_bytes; ++at) {
            const char letter = at < text.size() ? text[at] : '\0';
            const bool is_ascii = letter == '\0' || (letter >= ' ' && letter <= '~');
            u8(is_ascii ? letter : '_');
        }
    }

    void place(FieldPoint at)
    {
        u16(static_cast<std::uint16_t>(at.x));
        u16(static_cast<std::uint16_t>(at.y));
        if (has_depth(format_))
            u16(0);
    }

    void colour(const BeamPoint& point, const IldaPalette& palette)
    {
        if (is_indexed(format_))
            return u8(point.is_lit() ? palette.index(point.colour) : 0);
        u8(point.colour.blue);
        u8(point.colour.green);
        u8(point.colour.red);
    }

    std::string_view name_;
    IldaFormat format_;
    std::size_t frames_;
    std::vector<std::byte> bytes_;
};

}

std::vector<std::byte> ilda_file(std::string_view name, IldaFormat format, std::span<const BeamPoints> frames)
{
    IldaWriter writer{name, format, frames.size()};
    const IldaPalette palette{frames};
    if (is_indexed(format) && palette.is_needed())
        writer.palette(palette.colours());
    for (std::size_t number = 0; number < frames.size(); ++number)
        writer.frame(frames[number], number, palette);
    return writer.end();
}

}
