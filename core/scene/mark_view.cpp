#include "core/scene/mark_view.hpp"

#include "core/bytes/byte_reader.hpp"
#include "core/scene/time_code.hpp"

namespace kfast {

ClipView ClipCursor::next()
{
    --left_;
    ClipView clip;
    clip.name = read_name(bytes_);
    clip.begin = read_time_code(bytes_);
    clip.end = clip.begin + read_time_code(bytes_);
    clip.loop = static_cast<Loop>(bytes_.u8());
    return clip;
}

EventView EventCursor::next()
{
    time_ = time_ + read_time_code(bytes_);
    const std::string_view name = read_name(bytes_);
    return {name, time_};
}

}
