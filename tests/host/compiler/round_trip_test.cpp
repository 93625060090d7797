#include "core/player.hpp"
#include "core/scene/scene_view.hpp"
#include "host/compiler/match/measured_stroke.hpp"
#include "host/compiler/write_scene.hpp"
#include "tests/host/compiler/bone_comparison.hpp"
#include "tests/host/compiler/input_comparison.hpp"
#include "tests/host/compiler/object_comparison.hpp"
#include "tests/host/compiler/random_scene.hpp"
#include "tests/host/compiler/track_comparison.hpp"
#include "tests/host/compiler/unpacked_drawing.hpp"
#include "tests/rounds.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <vector>

namespace kfast::test {
namespace {

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
        CHECK(view_.camera() == scene_.camera);
        REQUIRE(view_.palette_size() == scene_.palette.size());
        for (std::size_t i = 0; i < scene_.palette.size(); ++i)
            CHECK(view_.colour(i) == scene_.palette[i]);
        compare_inputs(view_, scene_.inputs);
        compare_marks();
        compare_skeletons(view_, scene_.bones);
        REQUIRE(view_.symbol_count() == scene_.symbols.size());
        for (std::uint32_t i = 0; i < view_.symbol_count(); ++i)
            compare_items(view_.symbol(i), scene_.symbols[i].items);
        compare_items(view_.items(), scene_.items);
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
            REQUIRE(read.kind == kind_of(item));
            compare_tracks(view_, read.tracks, item);
            if (item.path)
                compare_path(read.path, *item.path);
            if (const auto* group = std::get_if<scene::Group>(&item.content))
                compare_items(ItemCursor{read.items}, group->items);
            else if (const auto* use = std::get_if<scene::Use>(&item.content))
                CHECK(read.symbol == use->symbol);
            else
                compare_object(view_, read, std::get<scene::Object>(item.content));
        }
        CHECK(cursor.at_end());
    }

    void compare_path(const PathView& read, const scene::Path& path)
    {
        CHECK(read.turns == path.turns);
        const scene::Stroke stroke = rounded(made_even(measured(path.stroke)));
        CHECK(unpacked(view_.drawing(read.drawing)) == scene::Drawing{{stroke}});
        ByteReader lengths = read.lengths;
        for (const MeasuredSegment& segment : measured(stroke))
            CHECK(std::abs(lengths.varint() / 16.0 - segment.length) <= 1 / 16.0);
        CHECK(lengths.left() == 0);
    }

    static ItemKind kind_of(const scene::Item& item)
    {
        const auto* object = std::get_if<scene::Object>(&item.content);
        return object != nullptr && (object->live || object->label)
                   ? ItemKind::live
                   : static_cast<ItemKind>(item.content.index());
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
        CHECK(player->picture().step_count <= scene.paint_steps());
    }
}

}

TEST_CASE("whatever is written comes back as it was, and can be played")
{
    std::mt19937 random{311};
    int written_scenes = 0;
    for (int round = 0; round < rounds(300); ++round) {
        const scene::Scene scene = random_scene(random);
        Diagnostics diagnostics;
        const auto bytes = write_scene(scene, diagnostics);
        if (!bytes)
            continue;
        const auto view = SceneView::parse(*bytes);
        REQUIRE(view);
        Comparison{*view, scene}.compare();
        play(*view, random);
        ++written_scenes;
    }
    CHECK(written_scenes > rounds(200));
}

}
