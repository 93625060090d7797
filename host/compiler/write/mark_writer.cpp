#include "host/compiler/write/mark_writer.hpp"

#include "host/compiler/write/name_writer.hpp"
#include "host/compiler/write/time_code.hpp"

namespace kfast {
namespace {

void write_clip(const scene::Clip& clip, ByteWriter& bytes)
{
    write_name(clip.name, bytes);
    bytes.varint(time_code(clip.begin));
    bytes.varint(time_code(clip.end - clip.begin));
    bytes.u8(static_cast<std::uint32_t>(clip.loop));
}

}

void write_marks(const scene::Scene& scene, ByteWriter& bytes)
{
    bytes.u8(static_cast<std::uint32_t>(scene.clips.size()));
    for (const scene::Clip& clip : scene.clips)
        write_clip(clip, bytes);
    Time before;
    for (const scene::Event& event : scene.events) {
        bytes.varint(time_code(event.time - before));
        write_name(event.name, bytes);
        before = event.time;
    }
}

}
