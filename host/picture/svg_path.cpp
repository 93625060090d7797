#include "host/picture/svg_path.hpp"

#include "host/picture/svg_number.hpp"

namespace kfast {

void SvgPath::begin(Point from)
{
    start_ = last_ = from;
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
    flatten(segment, sight_.pieces_of(segment), [this](Point to) { write('L', to); });
}

/// A fill is closed by way of the hub (docs/design.md, "Fills of broken strokes"); that it is closed at all
/// goes without saying.
void SvgPath::end(Point hub, bool is_closed)
{
    if (use_ == Use::fill && hub != start_ && hub != last_)
        write('L', hub);
    if (is_closed)
        data_ += 'Z';
}

void SvgPath::write(char command, Point at)
{
    data_ += command;
    const Point seen = sight_(at);
    data_ += svg_number(seen.x) + ' ' + svg_number(seen.y);
}

void SvgPath::write(Point at) { write(' ', at); }

}
