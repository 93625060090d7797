#include "host/preview/unseen_objects.hpp"

#include "core/clock.hpp"
#include "core/sweep.hpp"
#include "host/every_item.hpp"
#include "host/picture/timeline.hpp"
#include "host/preview/posed_scene.hpp"
#include "host/preview/told_player.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

namespace kfast {
namespace {

/// How far it came at best; the later ones are more.
enum class Shown : std::uint8_t { never, without_area, painted };

bool is_told(const ItemView& item)
{
    return item.kind == ItemKind::live &&
           (item.live.kind == LiveKind::drawing || item.live.kind == LiveKind::label);
}

/// Notes what pictures show, until there is nothing left to wait for.
class Watch {
public:
    explicit Watch(const SceneView& scene)
        : posed_{scene, scene.canvas(), Fit::contain}, painted_{scene, scene.canvas(), Fit::contain},
          cells_(CoverageRow::cells_for(scene.canvas().width))
    {
        std::size_t number = 0;
        every_item(scene, [&](const ItemView& item) {
            if (item.is_leaf() && !is_told(item))
                shown_[number] = Shown::never;
            ++number;
        });
    }

    bool has_seen_all() const
    {
        return std::ranges::all_of(shown_, [](const auto& entry) { return entry.second == Shown::painted; });
    }

    void set_input(std::uint32_t input, Time place)
    {
        posed_.set_input(input, place);
        painted_.set_input(input, place);
    }

    void look(Time moment)
    {
        painted_.player().show_moment(moment);
        posed_.visit(moment, [this](const SeenLeaf& leaf) {
            const auto entry = shown_.find(leaf.number());
            if (entry != shown_.end() && entry->second != Shown::painted)
                entry->second = paints(leaf.path) ? Shown::painted : Shown::without_area;
        });
    }

    std::vector<UnseenObject> unseen() const
    {
        std::vector<UnseenObject> objects;
        for (const auto& [number, shown] : shown_)
            if (shown != Shown::painted)
                objects.push_back({number, shown == Shown::never});
        return objects;
    }

private:
    /// Whether the picture of the player has something of it.
    bool paints(std::uint32_t path)
    {
        return std::ranges::any_of(painted_.player().picture().steps(), [&](const PaintStep& step) {
            return step.kind == PaintStep::Kind::layer && step.item == path &&
                   step.layer.colour.opacity > 0 && covers(step.layer);
        });
    }

    /// Within the panel. Sweeps a copy: what that changes in the store is set up anew when it begins.
    bool covers(Layer layer)
    {
        const Size panel = painted_.player().panel();
        OutlineStore outlines = painted_.player().picture().outlines;
        bool is_covered = false;
        layer.rewind();
        for (int y = std::max<int>(layer.top, 0);
             y < std::min<int>(layer.bottom, panel.height) && !is_covered; ++y) {
            CoverageRow coverage{cells_, panel.width};
            sweep_row(outlines, layer, y, coverage);
            coverage.take_spans([&](int, int, int level) { is_covered = is_covered || level > 0; });
        }
        return is_covered;
    }

    PosedScene posed_;
    ToldPlayer painted_;
    std::vector<std::int32_t> cells_;    ///< of a row
    std::map<std::size_t, Shown> shown_; ///< by the place in SceneFile::item_names
};

void look_at_frames(Watch& watch, const Timeline& timeline, int step)
{
    for (int frame = 0; frame < timeline.frame_count() && !watch.has_seen_all(); frame += step)
        watch.look(timeline.frame_time(frame));
}

/// Whether it could take much more than a second.
bool takes_long(const SceneView& scene, const Timeline& timeline)
{
    constexpr std::size_t most_bytes = 50'000'000;
    constexpr std::size_t least_of_a_frame = 10'000;
    return static_cast<std::size_t>(timeline.frame_count()) *
               std::max(scene.drawings().size(), least_of_a_frame) >
           most_bytes;
}

/// Through the range of a number; a few frames each, for it may move what time alone does not.
void turn_input(Watch& watch, const Timeline& timeline, std::uint32_t number, const InputView& input)
{
    constexpr int places = 32;
    constexpr int frames = 16;
    const int step = std::max(1, timeline.frame_count() / frames);
    for (int place = 0; place <= places && !watch.has_seen_all(); ++place) {
        watch.set_input(number, {whole_input.ticks / places * place});
        look_at_frames(watch, timeline, step);
    }
    watch.set_input(number, input.place_of(input.usual));
}

}

std::vector<UnseenObject> unseen_objects(const SceneView& scene)
{
    Timeline timeline = timeline_of(scene);
    timeline.stretch.loop = Loop::once; // with the last moment
    if (takes_long(scene, timeline))
        return {};
    Watch watch{scene};
    look_at_frames(watch, timeline, 1);
    for (std::uint32_t number = 0; number < scene.input_count() && !watch.has_seen_all(); ++number)
        if (const InputView input = scene.input(number); input.type == InputType::number)
            turn_input(watch, timeline, number, input);
    return watch.unseen();
}

}
