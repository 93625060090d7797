#pragma once

#include "host/compiler/write_scene.hpp"
#include "host/scene/model.hpp"

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// Short ways to say what a scene consists of.
namespace kfast::test {

/// One stroke of lines; coordinates in 1/16 px.
inline scene::Drawing lines(std::initializer_list<scene::Point> points)
{
    scene::Stroke stroke{.from = *points.begin(), .segments = {}};
    for (const scene::Point* at = points.begin() + 1; at != points.end(); ++at)
        stroke.segments.push_back({.cubic = false, .c1 = {}, .c2 = {}, .to = *at});
    return {{stroke}};
}

/// One stroke of one curve; coordinates in 1/16 px.
inline scene::Drawing curve(scene::Point from, scene::Point c1, scene::Point c2, scene::Point to)
{
    return {{{.from = from, .segments = {{.cubic = true, .c1 = c1, .c2 = c2, .to = to}}}}};
}

inline scene::Key key(int frame, scene::Drawing drawing, LawPair laws = {})
{
    return {.time = Time::frame(frame), .laws = laws, .drawing = std::move(drawing), .place = {}};
}

inline scene::Object filled(std::vector<scene::Key> keys)
{
    return {.fill = 0, .stroke = {}, .keys = std::move(keys)};
}

inline scene::Object stroked(int width, std::vector<scene::Key> keys)
{
    return {.fill = {}, .stroke = scene::StrokeStyle{.width = width}, .keys = std::move(keys)};
}

inline scene::Track fixed(Property property, std::int32_t value)
{
    return {property, {{.time = {}, .laws = {}, .value = value}}};
}

template <class Content>
scene::Item item(Content content, std::vector<scene::Track> tracks = {}, std::string name = {})
{
    return {.name = std::move(name), .tracks = std::move(tracks), .content = std::move(content), .place = {}};
}

inline scene::Scene scene_of(std::vector<scene::Item> items, std::vector<scene::Symbol> symbols = {})
{
    scene::Scene scene;
    scene.canvas = {64, 48};
    scene.length = Time::frame(40);
    scene.palette = {{0, 0, 0}, {255, 255, 255}};
    scene.symbols = std::move(symbols);
    scene.items = std::move(items);
    return scene;
}

/// The bytes of a scene that can be written.
inline std::vector<std::byte> written(const scene::Scene& scene)
{
    Diagnostics diagnostics;
    const auto bytes = write_scene(scene, diagnostics);
    if (!bytes)
        throw std::runtime_error{diagnostics.sorted().front().message};
    return *bytes;
}

}
