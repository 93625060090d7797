#include "host/preview/overlay/unseen_objects.hpp"

#include "core/time/time.hpp"
#include "host/picture/timeline.hpp"
#include "host/preview/board/standalone_player.hpp"
#include "host/preview/overlay/painted_items.hpp"
#include "host/preview/overlay/posed_scene.hpp"
#include "host/walk/every_item.hpp"
#include "host/walk/key_times.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <vector>

namespace kfast {
namespace {

/// What it reached at best; the later ones are more.
enum class Shown : std::uint8_t { never, without_area, painted };

bool is_input_leaf(const ItemView& item)
{
    return item.kind == ItemKind::live &&
           (item.live.kind == InputLeaf::drawing || item.live.kind == InputLeaf::label);
}

/// Notes what pictures show, until there is nothing left to wait for.
class Watch {
public:
    explicit Watch(const SceneView& scene)
        : posed_{scene, scene.canvas(), Fit::contain}, painted_{scene, scene.canvas(), Fit::contain}
    {
        std::size_t number = 0;
        every_item(scene, [&](const ItemView& item) {
            if (item.is_leaf() && !is_input_leaf(item))
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
        const std::span<const raster::PaintStep> steps = painted_.player().picture().steps();
        for (std::size_t number = 0; number != steps.size(); ++number)
            if (steps[number].kind == raster::PaintStep::Kind::layer && steps[number].item == path &&
                steps[number].colour.opacity > 0 && probe_.covers_any(number))
                return true;
        return false;
    }

    PosedScene posed_;
    StandalonePlayer painted_;
    LayerProbe probe_{painted_.player()};
    std::map<std::size_t, Shown> shown_; ///< by the number in SceneFile::item_names
};

void look_at(Watch& watch, std::span<const Time> moments)
{
    for (const Time moment : moments) {
        if (watch.has_seen_all())
            return;
        watch.look(moment);
    }
}

std::vector<Time> frames_of(const SceneView& scene)
{
    Timeline timeline = timeline_of(scene);
    timeline.stretch.loop = Loop::once; // including the last time
    std::vector<Time> moments;
    moments.reserve(static_cast<std::size_t>(timeline.frame_count()));
    for (int frame = 0; frame < timeline.frame_count(); ++frame)
        moments.push_back(timeline.frame_time(frame));
    return moments;
}

/// Times from 0 to `end`: evenly spaced ones, those of all keys of `driver`, and halfway between them.
std::vector<Time> sample_moments(const SceneView& scene, Driver driver, Time end)
{
    constexpr int spaces = 16;
    std::vector<Time> moments = key_times(scene, driver);
    for (int space = 0; space <= spaces; ++space)
        moments.push_back({static_cast<std::int32_t>(std::int64_t{end.ticks} * space / spaces)});
    std::ranges::sort(moments);
    const std::size_t count = moments.size();
    for (std::size_t before = 0; before + 1 < count; ++before)
        moments.push_back({std::midpoint(moments[before].ticks, moments[before + 1].ticks)});
    std::erase_if(moments, [end](Time moment) { return moment < Time{} || moment > end; });
    std::ranges::sort(moments);
    moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
    return moments;
}

/// The samples: times with the inputs at their defaults, and with one of them at each of its
/// values.
struct TurnedInput {
    std::uint32_t number = 0;
    Time default_value{};
    std::vector<Time> places;
};

struct Plan {
    std::vector<Time> frames;
    std::vector<Time> moments; ///< at each value of an input
    std::vector<TurnedInput> inputs;
};

Plan plan_of(const SceneView& scene)
{
    Plan plan{frames_of(scene), sample_moments(scene, {}, scene.length()), {}};
    for (std::uint32_t number = 0; number < scene.input_count(); ++number)
        if (const InputView input = scene.input(number); input.type == InputType::number)
            plan.inputs.push_back(
                {number, input.place_of(input.default_value),
                 sample_moments(scene, {static_cast<std::uint8_t>(number + 1)}, whole_input)});
    return plan;
}

/// Whether it could take much more than a second.
bool takes_long(const SceneView& scene, const Plan& plan)
{
    constexpr std::size_t max_bytes = 50'000'000;
    constexpr std::size_t min_of_a_frame = 10'000;
    std::size_t looks = plan.frames.size();
    for (const TurnedInput& input : plan.inputs)
        looks += input.places.size() * plan.moments.size();
    return looks * std::max(scene.drawings().size(), min_of_a_frame) > max_bytes;
}

/// Goes through the range of a number: it may show what time alone does not.
void turn(Watch& watch, const TurnedInput& input, std::span<const Time> moments)
{
    for (const Time place : input.places) {
        watch.set_input(input.number, place);
        look_at(watch, moments);
    }
    watch.set_input(input.number, input.default_value);
}

}

std::vector<UnseenObject> unseen_objects(const SceneView& scene)
{
    const Plan plan = plan_of(scene);
    if (takes_long(scene, plan))
        return {};
    Watch watch{scene};
    look_at(watch, plan.frames);
    for (const TurnedInput& input : plan.inputs)
        turn(watch, input, plan.moments);
    return watch.unseen();
}

}
