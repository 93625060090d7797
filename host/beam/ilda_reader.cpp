#include "host/beam/ilda_reader.hpp"

#include "host/beam/ilda_format.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace kfast {

namespace {

struct Header {
    IldaFormat format = IldaFormat::indexed_3d;
    std::string name;
    std::string company;
    std::uint16_t records = 0;
    std::uint16_t number = 0;
    std::uint16_t frames = 0;
    std::uint8_t projector = 0;
};

class IldaReader {
public:
    explicit IldaReader(std::span<const std::byte> file)
        : file_{file}, palette_{default_ilda_palette().begin(), default_ilda_palette().end()}
    {
    }

    IldaContents read()
    {
        while (section())
            ;
        if (at_ < file_.size())
            fail(counted(file_.size() - at_, "byte") + " behind the closing section");
        if (contents_.frames.empty())
            fail("there is no frame");
        return std::move(contents_);
    }

private:
    [[noreturn]] void fail(const std::string& reason) const { fail_at(at_, reason); }
    [[noreturn]] static void fail_at(std::size_t place, const std::string& reason)
    {
        throw std::invalid_argument("at byte " + std::to_string(place) + ": " + reason);
    }

    std::uint8_t u8() { return std::to_integer<std::uint8_t>(file_[at_++]); }

    std::uint16_t u16()
    {
        const int high = u8();
        return static_cast<std::uint16_t>(high << 8 | u8());
    }

    std::int16_t s16() { return static_cast<std::int16_t>(u16()); }

    /// Without the zeros after it.
    std::string text(std::size_t bytes)
    {
        std::string text;
        for (std::size_t left = bytes; left > 0; --left)
            text += static_cast<char>(u8());
        text.erase(text.find_last_not_of('\0') + 1);
        return text;
    }

    bool section()
    {
        const std::size_t begin = at_;
        const Header head = header();
        if (head.records == 0)
            return false;
        const std::size_t bytes = head.records * ilda_record_bytes(head.format);
        if (file_.size() - at_ < bytes)
            fail_at(file_.size(), "the file breaks off: the section at byte " + std::to_string(begin) +
                                      " has " + counted(bytes, "byte") + " of records");
        if (head.format == IldaFormat::palette)
            palette(begin, head);
        else
            frame(head);
        return true;
    }

    Header header()
    {
        if (file_.size() - at_ < ilda_header_bytes)
            fail_at(file_.size(), at_ == file_.size() ? "the closing section is missing"
                                                      : "the file breaks off in the header of a section");
        if (!std::ranges::equal(text(ilda_magic.size()), ilda_magic))
            fail_at(at_ - ilda_magic.size(), "no section begins here, with ILDA");
        at_ += 3; // reserved
        Header header;
        header.format = format();
        header.name = text(ilda_name_bytes);
        header.company = text(ilda_name_bytes);
        header.records = u16();
        header.number = u16();
        header.frames = u16();
        header.projector = u8();
        ++at_; // reserved
        return header;
    }

    IldaFormat format()
    {
        const std::uint8_t code = u8();
        if (code == 3 || code > static_cast<int>(IldaFormat::true_colour_2d))
            fail_at(at_ - 1, "format " + std::to_string(code) + " is none of 0, 1, 2, 4 and 5");
        return static_cast<IldaFormat>(code);
    }

    void palette(std::size_t begin, const Header& head)
    {
        if (head.records > max_ilda_colours)
            fail_at(begin, "a palette of " + std::to_string(head.records) + " colours: an index tells 256");
        palette_.clear();
        for (int left = head.records; left > 0; --left) {
            const std::uint8_t red = u8();
            const std::uint8_t green = u8();
            palette_.push_back({red, green, u8()});
        }
        ++contents_.palettes;
    }

    void frame(const Header& head)
    {
        IldaFrame frame{head.format, head.name, head.company, head.number, head.frames, head.projector, {}};
        for (int left = head.records; left > 0; --left)
            frame.points.push_back(point(head.format, left == 1));
        contents_.frames.push_back(std::move(frame));
    }

    IldaPoint point(IldaFormat format, bool is_last)
    {
        IldaPoint point;
        point.point.at = {.x = s16()};
        point.point.at.y = s16();
        point.z = has_depth(format) ? s16() : std::int16_t{0};
        const std::uint8_t status = u8();
        if (((status & ilda_last_point) != 0) != is_last)
            fail_at(at_ - 1, is_last ? "the last point of the frame is not told to be it"
                                     : "a point is told to be the last of the frame, but is not");
        const bool is_lit = (status & ilda_blanked) == 0;
        const Colour colour = is_indexed(format) ? indexed_colour(is_lit) : true_colour();
        if (is_lit)
            point.point.colour = colour;
        return point;
    }

    Colour indexed_colour(bool is_lit)
    {
        const std::uint8_t index = u8();
        if (index < palette_.size())
            return palette_[index];
        if (is_lit)
            fail_at(at_ - 1, "colour " + std::to_string(index) + " is not among the " +
                                 std::to_string(palette_.size()) + " of the palette");
        return {};
    }

    Colour true_colour()
    {
        const std::uint8_t blue = u8();
        const std::uint8_t green = u8();
        return {u8(), green, blue};
    }

    std::span<const std::byte> file_;
    std::size_t at_ = 0;
    std::vector<Colour> palette_;
    IldaContents contents_;
};

}

IldaContents read_ilda(std::span<const std::byte> file) { return IldaReader{file}.read(); }

namespace {

void stretch_to(IldaFacts& facts, FieldPoint at)
{
    facts.min = {std::min(facts.min.x, at.x), std::min(facts.min.y, at.y)};
    facts.max = {std::max(facts.max.x, at.x), std::max(facts.max.y, at.y)};
}

void add_step(IldaFacts& facts, FieldPoint from, const BeamPoint& to)
{
    double& longest = to.is_lit() ? facts.longest_lit_step : facts.longest_blanked_step;
    longest = std::max(longest, std::hypot(to.at.x - from.x, to.at.y - from.y));
}

void add(IldaFacts& facts, const IldaFrame& frame)
{
    facts.formats.insert(frame.format);
    facts.points += frame.points.size();
    facts.max_points = std::max(facts.max_points, frame.points.size());
    FieldPoint before = frame.points.front().point.at;
    for (const auto& [point, z] : frame.points) {
        facts.lit_points += point.is_lit();
        stretch_to(facts, point.at);
        add_step(facts, before, point);
        before = point.at;
    }
}

}

IldaFacts ilda_facts(const IldaContents& contents)
{
    IldaFacts facts;
    facts.min = facts.max = contents.frames.front().points.front().point.at;
    for (const IldaFrame& frame : contents.frames)
        add(facts, frame);
    return facts;
}

}
