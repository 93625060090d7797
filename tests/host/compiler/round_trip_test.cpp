#include "core/player.hpp"
#include "core/scene_view.hpp"
#include "host/compiler/match_by_length.hpp"
#include "host/compiler/write_scene.hpp"
#include "tests/host/compiler/random_scene.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <vector>

namespace kfast::test {
namespace {

scene::Point unpacked(Point point)
{
    const auto sixteenths = [](Fixed value) {
        return static_cast<std::int16_t>(value.raw() / (Fixed::one / 16));
    };
    return {sixteenths(point.x), sixteenths(point.y)};
}

scene::Drawing unpacked(PackedDrawing packed)
{
    scene::Drawing drawing;
    for (std::uint32_t stroke = 0; stroke < packed.strokes(); ++stroke) {
        const std::uint32_t segments = packed.next_stroke();
        scene::Stroke& read = drawing.strokes.emplace_back();
        read.from = unpacked(packed.start());
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Segment segment = packed.next_segment();
            if (segment.kind == Segment::Kind::cubic)
                read.segments.push_back({.cubic = true,
                                         .c1 = unpacked(segment.c1),
                                         .c2 = unpacked(segment.c2),
                                         .to = unpacked(segment.to)});
            else
                read.segments.push_back({.cubic = false, .c1 = {}, .c2 = {}, .to = unpacked(segment.to)});
        }
    }
    return drawing;
}

/// Compares what the core reads with the model that was written.
class Comparison {
public:
    Comparison(const SceneView& view, const scene::Scene& scene) : view_{view}, scene_{scene} {}

    void compare()
    {
        CHECK(view_.canvas() == scene_.canvas);
        CHECK(view_.frame_rate() == scene_.frame_rate);
        CHECK(view_.length() == scene_.length);
        CHECK(view_.loop() == scene_.loop);
        REQUIRE(view_.palette_size() == scene_.palette.size());
        for (std::size_t i = 0; i < scene_.palette.size(); ++i)
            CHECK(view_.colour(i) == scene_.palette[i]);
        compare_marks();
        REQUIRE(view_.symbol_count() == scene_.symbols.size());
        for (std::uint32_t i = 0; i < view_.symbol_count(); ++i)
            compare_items(view_.symbol(i), scene_.symbols[i].items);
        compare_items(view_.items(), scene_.items);
        CHECK(view_.max_edges() == expanded_edges(view_.items()));
    }

private:
    void compare_marks()
    {
        ClipCursor clips = view_.clips();
        for (const scene::Clip& clip : scene_.clips) {
            REQUIRE(!clips.at_end());
            const ClipView read = clips.next();
            CHECK(read.name == clip.name);
            CHECK(read.begin == clip.begin);
            CHECK(read.end == clip.end);
            CHECK(read.loop == clip.loop);
        }
        CHECK(clips.at_end());
        EventCursor events = view_.events();
        for (const scene::Event& event : scene_.events) {
            REQUIRE(!events.at_end());
            const EventView read = events.next();
            CHECK(read.name == event.name);
            CHECK(read.time == event.time);
        }
        CHECK(events.at_end());
    }

    void compare_items(ItemCursor cursor, const std::vector<scene::Item>& items)
    {
        for (const scene::Item& item : items) {
            REQUIRE(!cursor.at_end());
            const ItemView read = cursor.next();
            REQUIRE(static_cast<std::size_t>(read.kind) == item.content.index());
            compare_tracks(read.tracks, item);
            if (const auto* group = std::get_if<scene::Group>(&item.content))
                compare_items(ItemCursor{read.items}, group->items);
            else if (const auto* use = std::get_if<scene::Use>(&item.content))
                CHECK(read.symbol == use->symbol);
            else
                compare_object(read.object, std::get<scene::Object>(item.content));
        }
        CHECK(cursor.at_end());
    }

    /// A track that is not stored must be one that changes nothing.
    void compare_tracks(TrackCursor cursor, const scene::Item& item)
    {
        for (const scene::Track& track : item.tracks) {
            TrackCursor ahead = cursor;
            if (!ahead.at_end() && ahead.next().property == track.property)
                compare_track(cursor.next(), track);
            else
                CHECK(changes_nothing(track, item));
        }
        CHECK(cursor.at_end());
    }

    static bool changes_nothing(const scene::Track& track, const scene::Item& item)
    {
        const auto* object = std::get_if<scene::Object>(&item.content);
        const std::int32_t value = track.keys.front().value;
        switch (track.property) {
        case Property::scale_x:
        case Property::scale_y:
            return track.keys.size() == 1 && value == 4096;
        case Property::opacity:
            return track.keys.size() == 1 && value == 255;
        case Property::visible:
            return track.keys.size() == 1 && value == 1;
        case Property::fill:
            return track.keys.size() == 1 && static_cast<std::size_t>(value) == *object->fill;
        case Property::stroke:
            return track.keys.size() == 1 && static_cast<std::size_t>(value) == object->stroke->colour;
        case Property::width:
            return track.keys.size() == 1 && value == object->stroke->width;
        case Property::pivot_x:
        case Property::pivot_y:
            return (track.keys.size() == 1 && value == 0) || !turns_or_grows(item);
        default:
            return track.keys.size() == 1 && value == 0;
        }
    }

    static bool turns_or_grows(const scene::Item& item)
    {
        return std::ranges::any_of(item.tracks, [&item](const scene::Track& track) {
            return track.property >= Property::rotation && track.property <= Property::scale_y &&
                   !changes_nothing(track, item);
        });
    }

    void compare_track(const TrackView& read, const scene::Track& track)
    {
        REQUIRE(read.is_fixed == (track.keys.size() == 1));
        if (read.is_fixed) {
            CHECK(read.value == track.keys.front().value);
            return;
        }
        TrackKeyCursor keys = read.keys;
        for (const scene::TrackKey& key : track.keys) {
            REQUIRE(!keys.at_end());
            const TrackKey stored = keys.next();
            CHECK(stored.time == key.time);
            CHECK(stored.value == key.value);
            compare_laws(stored.laws, key.laws, keys.at_end());
        }
        CHECK(keys.at_end());
    }

    void compare_laws(std::uint32_t number, const LawPair& laws, bool is_last)
    {
        CHECK(view_.laws(number) == (is_last ? LawPair{} : laws));
    }

    void compare_object(const ObjectView& read, const scene::Object& object)
    {
        const ObjectStyle& style = read.style;
        REQUIRE(style.is_filled == object.fill.has_value());
        REQUIRE(style.is_stroked == object.stroke.has_value());
        if (object.fill) {
            CHECK(style.fill == *object.fill);
            CHECK(style.fill_rule == object.fill_rule);
        }
        if (const auto& stroke = object.stroke) {
            CHECK(style.stroke == stroke->colour);
            CHECK(style.width == stroke->width);
            CHECK(style.cap == stroke->cap);
            CHECK(style.join == stroke->join);
            if (stroke->join == Join::miter)
                CHECK(style.miter_limit == stroke->miter_limit);
        }
        KeyCursor keys = read.keys();
        for (std::size_t i = 0; i < object.keys.size(); ++i) {
            REQUIRE(!keys.at_end());
            const Key key = keys.next();
            CHECK(key.time == object.keys[i].time);
            compare_laws(key.laws, object.keys[i].laws, keys.at_end());
            compare_drawings(key, read.has_arrivals, object, i);
        }
        CHECK(keys.at_end());
    }

    void compare_drawings(const Key& read, bool has_arrivals, const scene::Object& object, std::size_t i)
    {
        const scene::Key& key = object.keys[i];
        const scene::Key& next = object.keys[std::min(i + 1, object.keys.size() - 1)];
        MatchedDrawings expected{key.drawing, next.drawing};
        if (key.match == scene::Match::length && &next != &key)
            expected = *match_by_length(key.drawing, next.drawing);
        CHECK(unpacked(view_.drawing(read.drawing)) == expected.from);
        if (has_arrivals)
            CHECK(unpacked(view_.drawing(read.arrival)) == expected.to);
        else
            CHECK((key.match == scene::Match::count || &next == &key));
    }

    std::uint32_t expanded_edges(ItemCursor items)
    {
        std::uint32_t edges = 0;
        while (!items.at_end()) {
            const ItemView item = items.next();
            edges += item.kind == ItemKind::object  ? item.object.max_edges
                     : item.kind == ItemKind::group ? expanded_edges(ItemCursor{item.items})
                                                    : expanded_edges(view_.symbol(item.symbol));
        }
        return edges;
    }

    const SceneView& view_;
    const scene::Scene& scene_;
};

void play(const SceneView& scene, std::mt19937& random)
{
    constexpr Size panel{20, 30};
    std::vector<std::byte> block(Player::block_bytes(scene, panel));
    auto player = Player::create(scene, panel, Fit::contain, block);
    REQUIRE(player);
    for (int moment = 0; moment < 10; ++moment) {
        player->show({static_cast<std::int32_t>(random() % 200'000)});
        CHECK(player->edge_count() <= scene.max_edges());
        CHECK(player->step_count() <= scene.paint_steps());
    }
}

}

TEST_CASE("whatever is written comes back as it was, and can be played")
{
    std::mt19937 random{311};
    int written_scenes = 0;
    for (int round = 0; round < 1500; ++round) {
        const scene::Scene scene = random_scene(random);
        Diagnostics diagnostics;
        const auto bytes = write_scene(scene, diagnostics);
        if (!bytes) // too many edges
            continue;
        const auto view = SceneView::parse(*bytes);
        REQUIRE(view);
        Comparison{*view, scene}.compare();
        play(*view, random);
        ++written_scenes;
    }
    CHECK(written_scenes > 1000);
}

}
