#include "host/kdl/parser.hpp"
#include "host/scene/scene_reader.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>

using namespace kfast;

namespace {

void demand(bool condition)
{
    if (!condition)
        std::abort();
}

/// What is missing at the end of the text is marked behind it.
void check_messages(const Diagnostics& diagnostics, const SourceText& source)
{
    for (const Diagnostic& diagnostic : diagnostics.sorted()) {
        demand(diagnostic.place.offset <= source.text.size());
        demand(diagnostic.place.length <= source.text.size() - diagnostic.place.offset + 1);
        demand(!format(diagnostic, source).empty());
    }
}

void check_stroke(const scene::Stroke& stroke)
{
    scene::Point from = stroke.from;
    for (const scene::Segment& segment : stroke.segments) {
        demand(segment.to != from || (segment.cubic && (segment.c1 != from || segment.c2 != from)));
        from = segment.to;
    }
}

void check_object(const scene::Object& object, std::size_t colours)
{
    demand(object.fill || object.stroke);
    demand(!object.fill || *object.fill < colours);
    demand(!object.stroke || (object.stroke->colour < colours && object.stroke->width >= 1));
    demand(!object.keys.empty() && object.keys.front().time >= Time{0});
    demand(std::ranges::adjacent_find(object.keys, std::greater_equal{}, &scene::Key::time) ==
           object.keys.end());
    for (const scene::Key& key : object.keys)
        for (const scene::Stroke& stroke : key.drawing.strokes)
            check_stroke(stroke);
}

}

/// Any bytes at all: there is either an error or a scene that keeps what model.hpp promises.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const SourceText source{.name = "fuzz", .text = std::string(data, data + size)};
    Diagnostics diagnostics;
    const kdl::Document document = kdl::parse(source.text, diagnostics);
    const auto scene = scene::read_scene(document, source, diagnostics);
    check_messages(diagnostics, source);
    demand(scene.has_value() != diagnostics.has_errors());
    if (!scene)
        return 0;
    demand(scene->length >= Time::frame(1) && !scene->palette.empty());
    for (const scene::Object& object : scene->objects)
        check_object(object, scene->palette.size());
    return 0;
}
