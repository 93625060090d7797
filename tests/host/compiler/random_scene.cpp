#include "tests/host/compiler/random_scene.hpp"

#include <algorithm>
#include <string>

namespace kfast::test {
namespace {

class SceneMaker {
public:
    explicit SceneMaker(std::mt19937& random) : random_{random} {}

    scene::Scene scene()
    {
        scene_.canvas = {static_cast<std::int16_t>(within(1, 300)),
                         static_cast<std::int16_t>(within(1, 300))};
        scene_.frame_rate = static_cast<std::uint32_t>(within(1, 1'000'000));
        scene_.length = {within(1024, 100'000)};
        scene_.loop = loop();
        for (int left = within(1, 5); left > 0; --left)
            scene_.palette.push_back({byte(), byte(), byte(), byte()});
        scene_.palette.front().opacity = 255;
        for (int left = within(0, 3); left > 0; --left) {
            scene::Symbol symbol{name(), items(1)};
            scene_.symbols.push_back(std::move(symbol));
        }
        scene_.items = items(2);
        make_marks();
        return std::move(scene_);
    }

private:
    int within(int least, int most)
    {
        return least + static_cast<int>(random_() % static_cast<unsigned>(most - least + 1));
    }
    bool sometimes() { return random_() % 3 == 0; }
    std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }
    Loop loop() { return static_cast<Loop>(random_() % 3); }
    std::size_t colour() { return random_() % scene_.palette.size(); }
    std::string name() { return std::string(static_cast<std::size_t>(within(1, 255)), 'n'); }

    VelocityLaw law()
    {
        const auto control = [this](int least, int most) {
            return static_cast<std::int16_t>(within(least, most));
        };
        const auto x = [&] { return control(0, VelocityLaw::control_one); };
        const auto y = [&] { return control(VelocityLaw::lowest_y, VelocityLaw::highest_y); };
        switch (within(0, 6)) {
        case 5:
            return VelocityLaw::in_steps(static_cast<std::uint16_t>(within(1, 65535)));
        case 6: {
            const std::int16_t x1 = x();
            const std::int16_t y1 = y();
            const std::int16_t x2 = x();
            return VelocityLaw::bezier(x1, y1, x2, y());
        }
        default:
            return {.kind = static_cast<VelocityLaw::Kind>(within(0, 4))};
        }
    }

    LawPair laws()
    {
        if (sometimes())
            return {};
        const VelocityLaw x = law();
        return {x, law()};
    }

    /// Rises from call to call.
    Time next_time(Time before, bool is_first)
    {
        const int step = within(is_first ? 0 : 1, 20);
        return before + (sometimes() ? Time{step * 100} : Time::frame(step));
    }

    scene::Point point()
    {
        const auto x = static_cast<std::int16_t>(within(-1600, 3200));
        return {x, static_cast<std::int16_t>(within(-1600, 3200))};
    }

    scene::Drawing drawing()
    {
        scene::Drawing drawing;
        drawing.strokes.resize(static_cast<std::size_t>(within(0, 3)));
        for (scene::Stroke& stroke : drawing.strokes) {
            stroke.from = point();
            for (int left = within(0, 5); left > 0; --left)
                stroke.segments.push_back(segment());
            if (sometimes() && stroke.segments.size() > 1)
                stroke.segments.back().to = stroke.from;
        }
        return drawing;
    }

    scene::Segment segment()
    {
        if (sometimes())
            return {.cubic = true, .c1 = point(), .c2 = point(), .to = point()};
        return {.cubic = false, .c1 = {}, .c2 = {}, .to = point()};
    }

    scene::Object object()
    {
        scene::Object object;
        if (sometimes() || sometimes())
            object.fill = colour();
        if (!object.fill || sometimes())
            object.stroke = scene::StrokeStyle{.colour = colour(),
                                               .width = within(1, 400),
                                               .cap = static_cast<Cap>(within(0, 2)),
                                               .join = static_cast<Join>(within(0, 2)),
                                               .miter_limit = within(8, 255)};
        if (object.fill)
            object.fill_rule = static_cast<FillRule>(within(0, 1));
        Time time;
        for (int left = within(1, 4), first = left; left > 0; --left) {
            time = next_time(time, left == first);
            object.keys.push_back({.time = time,
                                   .laws = laws(),
                                   .match = sometimes() ? scene::Match::length : scene::Match::count,
                                   .drawing = drawing(),
                                   .place = {}});
        }
        if (sometimes())
            object.keys.back().drawing = object.keys.front().drawing;
        return object;
    }

    std::int32_t value_of(Property property)
    {
        switch (property) {
        case Property::rotation:
            return within(-100'000, 100'000);
        case Property::scale_x:
        case Property::scale_y:
            return within(-6000, 6000);
        case Property::opacity:
            return within(0, 255);
        case Property::visible:
            return within(0, 1);
        case Property::fill:
        case Property::stroke:
            return static_cast<std::int32_t>(colour());
        case Property::width:
            return within(0, 300);
        default:
            return within(-3000, 3000);
        }
    }

    scene::Track track(Property property)
    {
        scene::Track track{property, {}};
        Time time;
        for (int left = within(1, 3), first = left; left > 0; --left) {
            time = next_time(time, left == first);
            track.keys.push_back({.time = time, .laws = laws(), .value = value_of(property)});
        }
        return track;
    }

    std::vector<scene::Track> tracks(const scene::Object* object)
    {
        std::vector<scene::Track> tracks;
        for (std::size_t number = 0; number < property_count; ++number) {
            const auto property = static_cast<Property>(number);
            const bool needs_fill = property == Property::fill;
            const bool needs_stroke = property == Property::stroke || property == Property::width;
            const bool has_it =
                object != nullptr && (needs_fill ? object->fill.has_value() : object->stroke.has_value());
            if ((!needs_fill && !needs_stroke) || has_it)
                if (random_() % 6 == 0)
                    tracks.push_back(track(property));
        }
        return tracks;
    }

    std::vector<scene::Item> items(int levels)
    {
        std::vector<scene::Item> items;
        for (int left = within(0, 3); left > 0; --left)
            items.push_back(item(levels));
        return items;
    }

    scene::Item item(int levels)
    {
        scene::Item item{.name = "i", .tracks = {}, .content = scene::Group{}, .place = {}};
        if (levels > 0 && sometimes())
            item.content = scene::Group{items(levels - 1)};
        else if (!scene_.symbols.empty() && sometimes())
            item.content = scene::Use{random_() % scene_.symbols.size()};
        else
            item.content = object();
        item.tracks = tracks(std::get_if<scene::Object>(&item.content));
        return item;
    }

    void make_marks()
    {
        for (int left = within(0, 3); left > 0; --left) {
            const int begin = within(0, scene_.length.ticks - 1);
            scene_.clips.push_back({name(), {begin}, {within(begin + 1, scene_.length.ticks)}, loop()});
        }
        for (int left = within(0, 3); left > 0; --left)
            scene_.events.push_back({name(), {within(0, scene_.length.ticks)}});
        std::ranges::sort(scene_.events, {}, &scene::Event::time);
    }

    std::mt19937& random_;
    scene::Scene scene_;
};

}

scene::Scene random_scene(std::mt19937& random) { return SceneMaker{random}.scene(); }

}
