#include "core/mark_view.hpp"

#include "core/time_code.hpp"

#include <algorithm>

namespace kfast {
namespace {

std::string_view read_name(ByteReader& bytes)
{
    const std::size_t length = bytes.u8();
    const auto* letters = reinterpret_cast<const char*>(bytes.rest().data());
    const std::string_view name{letters, std::min(length, bytes.left())};
    bytes.skip(length);
    return name;
}

}

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
