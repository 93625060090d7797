#include "core/backbone_view.hpp"

namespace kfast {

BackboneKeyCursor::BackboneKeyCursor(ByteReader& bytes)
    : beats_{BeatCursor::take(bytes, BeatCursor::one())}, drawings_{PackedValues::take(bytes, beats_.count())}
{
}

BackboneKey BackboneKeyCursor::next()
{
    const Beat beat = beats_.next();
    return {
        .time = beat.time, .laws = beat.laws, .drawing = static_cast<std::uint32_t>(drawings_[beat.index])};
}

}
