#include "tests/host/compiler/random_scene.hpp"

#include "core/kfb_limits.hpp"
#include "host/scene/binding.hpp"

#include <algorithm>
#include <array>
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
        scene_.camera = within(kfb::min_camera, 1000);
        for (int left = within(1, 5); left > 0; --left)
            scene_.palette.push_back({byte(), byte(), byte(), byte()});
        scene_.palette.front().opacity = 255;
        for (int left = within(0, 2); left > 0; --left)
            scene_.bones.push_back({name(), bones(), {}});
        for (int left = within(0, 3); left > 0; --left) {
            scene::Symbol symbol{name(), items(1)};
            scene_.symbols.push_back(std::move(symbol));
        }
        scene_.items = items(2);
        make_marks();
        make_inputs();
        return std::move(scene_);
    }

    scene::Scene carried_scene()
    {
        scene_.canvas = {240, 240};
        scene_.length = Time::frame(40);
        scene_.palette = {{0, 0, 0}};
        scene_.bones.push_back({name(), moderate_bones(), {}});
        scene::Object object;
        object.fill = 0;
        Time time;
        for (int left = within(1, 3), first = left; left > 0; --left) {
            time = next_time(time, left == first);
            object.keys.push_back({.time = time, .laws = soft_laws(), .drawing = curves(), .place = {}});
        }
        object.skin = skin(0, object.keys.front().drawing);
        scene_.items.push_back({.name = "i", .tracks = {}, .content = object, .place = {}});
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

    scene::Drawing drawing() { return drawing(within(0, 3)); }

    scene::Drawing drawing(int strokes)
    {
        scene::Drawing drawing;
        drawing.strokes.resize(static_cast<std::size_t>(strokes));
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

    /// One stroke within 60 px of the origin.
    scene::Drawing curves()
    {
        const auto near = [this] {
            const auto x = static_cast<std::int16_t>(within(-960, 960));
            return scene::Point{x, static_cast<std::int16_t>(within(-960, 960))};
        };
        scene::Stroke stroke{.from = near(), .segments = {}};
        for (int left = within(1, 4); left > 0; --left) {
            const scene::Point c1 = near();
            const scene::Point c2 = near();
            stroke.segments.push_back({.cubic = true, .c1 = c1, .c2 = c2, .to = near()});
        }
        return {{stroke}};
    }

    LawPair soft_laws()
    {
        const VelocityLaw law{.kind = static_cast<VelocityLaw::Kind>(within(0, 3))};
        return {law, law};
    }

    std::int32_t bone_value(BoneQuantity quantity, bool turns_as_written)
    {
        if (quantity == BoneQuantity::angle)
            return turns_as_written ? within(-100'000, 100'000) : within(0, 65535);
        return quantity == BoneQuantity::length ? within(0, 3000) : within(-3000, 3000);
    }

    scene::Bone bone()
    {
        scene::Bone bone;
        bone.name = name();
        bone.turns_as_written = sometimes();
        bone.set_up = {within(0, 65535), within(-3000, 3000), within(-3000, 3000), within(1, 2000)};
        if (sometimes())
            poses_ = pose_keys();
        for (std::size_t i = 0; i < bone.keys.size(); ++i)
            if (sometimes()) {
                bone.keys[i] = poses_;
                for (scene::TrackKey& key : bone.keys[i])
                    key.value = bone_value(static_cast<BoneQuantity>(i), bone.turns_as_written);
            }
        return bone;
    }

    std::vector<scene::TrackKey> pose_keys()
    {
        std::vector<scene::TrackKey> keys;
        Time time;
        for (int left = within(1, 6), first = left; left > 0; --left) {
            time = next_time(time, left == first);
            keys.push_back({.time = time, .laws = laws(), .value = 0});
        }
        return keys;
    }

    std::vector<scene::Bone> bones()
    {
        poses_ = pose_keys();
        std::vector<scene::Bone> bones;
        for (int left = within(1, 5); left > 0; --left) {
            scene::Bone next = bone();
            if (!bones.empty() && !sometimes()) {
                next.parent = random_() % bones.size();
                next.is_at_tip = sometimes();
            }
            bones.push_back(std::move(next));
        }
        return bones;
    }

    /// Within 300 px, so that nothing is held at the limits of coordinates.
    std::vector<scene::Bone> moderate_bones()
    {
        std::vector<scene::Bone> all = bones();
        for (scene::Bone& bone : all) {
            bone.set_up = {within(0, 65535), within(-640, 640), within(-640, 640), within(320, 960)};
            const std::array<std::int32_t, bone_quantity_count> spread{0, 160, 160, 300};
            for (std::size_t i = 0; i < bone.keys.size(); ++i)
                for (scene::TrackKey& key : bone.keys[i]) {
                    key.laws = soft_laws();
                    if (i != 0)
                        key.value = bone.set_up[i] + within(-spread[i], spread[i]);
                }
        }
        return all;
    }

    scene::Binding binding(std::size_t bones)
    {
        std::vector<scene::WeightedBone> weights{{random_() % bones, 1}};
        for (std::size_t i = 0; i < bones; ++i)
            if (i != weights[0].bone && sometimes())
                weights.push_back({i, within(1, 1000) / 1000.0});
        return scene::bound(weights);
    }

    scene::Skin skin(std::size_t skeleton, const scene::Drawing& first)
    {
        scene::Skin skin{.bones = skeleton, .bindings = {}, .place = {}};
        const std::size_t bones = scene_.bones[skeleton].bones.size();
        for (std::size_t i = 0; i < point_count(first); ++i)
            skin.bindings.push_back(i > 0 && sometimes() ? skin.bindings.back() : binding(bones));
        return skin;
    }

    /// A skin needs as many strokes in all drawings that are not empty.
    void cover_with_skin(scene::Object& object)
    {
        const int strokes = within(1, 3);
        const scene::Drawing* first = nullptr;
        for (scene::Key& key : object.keys) {
            key.match = scene::Match::count;
            key.drawing = sometimes() ? scene::Drawing{} : drawing(strokes);
            if (first == nullptr && !key.drawing.strokes.empty())
                first = &key.drawing;
        }
        object.skin = skin(random_() % scene_.bones.size(), first != nullptr ? *first : scene::Drawing{});
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
        if (random_() % 8 == 0)
            show_text(object);
        else if (!scene_.bones.empty() && sometimes())
            cover_with_skin(object);
        else if (random_() % 8 == 0)
            object.backbone_keys = backbone_keys();
        else if (object.stroke && sometimes())
            make_wires(object);
        object.beam = beam_style(object, time);
        return object;
    }

    /// Of lines, with a depth for each of their points.
    void make_wires(scene::Object& object)
    {
        object.fill.reset();
        object.has_depths = true;
        for (scene::Key& key : object.keys) {
            key.match = scene::Match::count;
            for (scene::Stroke& stroke : key.drawing.strokes)
                for (scene::Segment& segment : stroke.segments)
                    segment = {.cubic = false, .c1 = {}, .c2 = {}, .to = segment.to};
            key.depths = key.drawing;
            for (scene::Stroke& stroke : key.depths.strokes) {
                stroke.from = {point().x, 0};
                for (scene::Segment& segment : stroke.segments)
                    segment.to = {point().x, 0};
            }
        }
    }

    /// Draws no random number: scenes stay what they are without it.
    static BeamStyle beam_style(const scene::Object& object, Time time)
    {
        BeamStyle style{.parts = static_cast<BeamParts>(time.ticks & (object.fill ? 3 : 1))};
        if (style.has_hatching()) {
            style.spacing = 8 + time.ticks % 1000;
            style.direction = BinaryAngle::from_raw(time.ticks);
        }
        return style;
    }

    /// Of an input of its own, the number of which is one of `texts_`.
    void show_text(scene::Object& object)
    {
        if (texts_.size() == most_texts)
            return;
        scene::TextInput text{.glyphs = {}, .most = static_cast<std::uint32_t>(within(1, 12)), .usual = {}};
        char32_t character = U' ';
        for (int left = within(1, 9); left > 0; --left, character += static_cast<char32_t>(within(1, 3)))
            text.glyphs += character;
        for (int left = within(0, static_cast<int>(text.most)); left > 0; --left)
            text.usual += text.glyphs[random_() % text.glyphs.size()];
        object.keys.clear();
        object.label = scene::Label{.input = texts_.size(),
                                    .at = point(),
                                    .align = static_cast<Align>(within(0, 2)),
                                    .spacing = within(-9000, 9000),
                                    .glyphs = {},
                                    .kerning = {}};
        for (std::size_t i = 0; i < text.glyphs.size(); ++i)
            object.label->glyphs.push_back({drawing(), within(-9000, 200'000)});
        for (std::size_t i = 0; i < text.glyphs.size(); ++i)
            if (sometimes())
                object.label->kerning.push_back({static_cast<std::uint8_t>(i),
                                                 static_cast<std::uint8_t>(random_() % text.glyphs.size()),
                                                 within(1, 5000)});
        texts_.push_back(text);
    }

    std::vector<scene::Point> points(int count)
    {
        std::vector<scene::Point> points;
        for (; count > 0; --count)
            points.push_back(point());
        return points;
    }

    std::vector<scene::BackboneKey> backbone_keys()
    {
        std::vector<int> sizes;
        for (int left = within(1, 3); left > 0; --left)
            sizes.push_back(within(2, 5));
        std::vector<scene::BackboneKey> keys;
        Time time;
        for (int left = within(1, 3), first = left; left > 0; --left) {
            time = next_time(time, left == first);
            keys.push_back({.time = time, .laws = laws(), .backbones = {}, .place = {}});
            for (const int size : sizes)
                keys.back().backbones.push_back({points(size), points(size), points(size)});
        }
        return keys;
    }

    std::int32_t value_of(Property property)
    {
        switch (property) {
        case Property::rotation_x:
        case Property::rotation_y:
        case Property::rotation:
            return within(-100'000, 100'000);
        case Property::scale_x:
        case Property::scale_y:
            return within(-6000, 6000);
        case Property::along:
            return within(0, path_whole);
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
        scene::Track track{property, {}, may_be_smooth(property) && sometimes()};
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
        if (std::ranges::find(item.tracks, Property::along, &scene::Track::property) != item.tracks.end())
            item.path = path();
        return item;
    }

    scene::Path path()
    {
        scene::Path path{{point(), {}}, sometimes()};
        for (int left = within(1, 3); left > 0; --left)
            path.stroke.segments.push_back(segment());
        return path;
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

    void make_inputs()
    {
        for (const scene::TextInput& text : texts_)
            scene_.inputs.push_back({.name = name(), .type = InputType::text, .text = text});
        for (int left = within(-3, 3); left > 0; --left) {
            const int least = within(-90'000, 90'000);
            const int most = within(least + 1, 100'000);
            scene_.inputs.push_back({name(), least, most, within(least, most)});
        }
        numbers_ = scene_.inputs.size();
        for (int left = within(-2, 2); left > 0; --left)
            scene_.inputs.push_back(drawing_input());
        for (scene::Bones& skeleton : scene_.bones)
            for (scene::Bone& bone : skeleton.bones)
                if (std::ranges::all_of(bone.keys, lie_on_input<scene::TrackKey>))
                    bone.clock = any_clock();
        for (scene::Symbol& symbol : scene_.symbols)
            bind(symbol.items);
        bind(scene_.items);
    }

    scene::Input drawing_input()
    {
        scene::Drawing usual = drawing();
        for (scene::Stroke& stroke : usual.strokes)
            std::erase_if(stroke.segments, [](const scene::Segment& segment) { return segment.cubic; });
        const std::size_t points = std::max<std::size_t>(point_count(usual), 1) + random_() % 4;
        const std::size_t strokes = std::max<std::size_t>(usual.strokes.size(), 1);
        return {.name = name(),
                .type = InputType::drawing,
                .drawing = {.strokes = strokes, .points = points, .usual = std::move(usual)}};
    }

    void bind(scene::Object& object)
    {
        const std::size_t drawings = scene_.inputs.size() - numbers_;
        if (drawings != 0 && !object.label && sometimes()) {
            object.keys.clear();
            object.skin = {};
            object.backbone_keys.clear();
            object.has_depths = false;
            object.live = numbers_ + random_() % drawings;
        } else if (object.keys.size() > 1 && lie_on_input(object.keys) &&
                   lie_on_input(object.backbone_keys)) {
            object.clock = any_clock();
        }
    }

    void bind(std::vector<scene::Item>& items)
    {
        for (scene::Item& item : items) {
            for (scene::Track& track : item.tracks)
                if (lie_on_input(track.keys))
                    track.clock = any_clock();
            if (auto* group = std::get_if<scene::Group>(&item.content))
                bind(group->items);
            else if (auto* object = std::get_if<scene::Object>(&item.content))
                bind(*object);
        }
    }

    template <class Key>
    static bool lie_on_input(const std::vector<Key>& keys)
    {
        return keys.empty() || keys.back().time <= whole_input;
    }

    /// The time, or a number: these lie behind the texts.
    Clock any_clock()
    {
        const std::size_t numbers = numbers_ - texts_.size();
        const std::size_t clock = random_() % (numbers + 1);
        return {static_cast<std::uint8_t>(clock == 0 ? 0 : texts_.size() + clock)};
    }

    static constexpr std::size_t most_texts = 8;

    std::mt19937& random_;
    std::size_t numbers_ = 0; ///< inputs before the drawings: texts, then numbers
    scene::Scene scene_;
    std::vector<scene::TextInput> texts_;
    std::vector<scene::TrackKey> poses_; ///< when bones have keys, until it changes
};

}

scene::Scene random_scene(std::mt19937& random) { return SceneMaker{random}.scene(); }

scene::Scene random_carried_scene(std::mt19937& random) { return SceneMaker{random}.carried_scene(); }

}
