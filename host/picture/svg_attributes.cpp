#include "host/picture/svg_attributes.hpp"

#include <cstdint>
#include <cstdlib>

namespace kfast {

namespace {

constexpr std::int64_t parts = 10'000;

/// "1.25" for 12500
std::string decimal(std::int64_t count)
{
    std::string digits = std::to_string(std::abs(count) % parts + parts).substr(1);
    digits.erase(digits.find_last_not_of('0') + 1);
    const std::string whole = std::to_string(std::abs(count) / parts);
    return (count < 0 ? "-" : "") + whole + (digits.empty() ? "" : "." + digits);
}

}

std::string svg_number(Fixed length)
{
    const std::int64_t raw = length.raw();
    const std::int64_t scaled = std::abs(raw) * parts + Fixed::one / 2;
    const std::int64_t count = scaled / Fixed::one;
    return decimal(raw < 0 ? -count : count);
}

std::string svg_share(std::uint32_t opacity) { return decimal((opacity * parts + 127) / 255); }

void SvgPath::begin(Point from)
{
    start_ = last_ = from;
    piece_begin_ = data_.size();
    write('M', from);
}

void SvgPath::add(const Segment& segment)
{
    last_ = segment.to;
    if (segment.kind == Segment::Kind::cubic && !is_projected_) {
        write('C', segment.c1);
        write(segment.c2);
        return write(segment.to);
    }
    flatten(segment, view_.pieces_of(segment), [this](Point to) { write('L', to); });
}

/// A fill is closed through the hub (core/pose/README.md, "Fills of broken strokes"); that it is closed
/// at all is implied.
void SvgPath::end(Point hub, bool is_closed)
{
    if (use_ == Use::fill && hub != start_ && hub != last_)
        write('L', hub);
    if (is_closed)
        data_ += 'Z';
}

/// Both pieces at a seam become one, so that they are joined.
void SvgPath::end_piece(Point hub, PieceEnd end)
{
    switch (end) {
    case PieceEnd::open:
    case PieceEnd::closed:
        return this->end(hub, end == PieceEnd::closed);
    case PieceEnd::after_seam: {
        const std::size_t first = data_.find_first_of("CL", piece_begin_);
        after_seam_ = first == data_.npos ? "" : data_.substr(first);
        data_.resize(piece_begin_);
        return;
    }
    case PieceEnd::at_seam:
        data_ += after_seam_;
    }
}

void SvgPath::write(char command, Point at)
{
    data_ += command;
    const Point seen = view_(at);
    data_ += svg_number(seen.x) + ' ' + svg_number(seen.y);
}

void SvgPath::write(Point at) { write(' ', at); }

}
