#include "host/commands/options/play_options.hpp"

#include "host/commands/options/option_groups.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/commands/text/summary.hpp"
#include "host/text/suggestion.hpp"

#include <string_view>
#include <vector>

namespace kfast {
namespace {

[[noreturn]] void refuse_clip(const std::string& name, const SceneView& scene)
{
    const std::vector<std::string_view> names = clip_names(scene);
    const std::string hint = names.empty() ? "the scene has none: leave out --clip" : suggestion(name, names);
    throw CLI::ValidationError("--clip", "there is no clip '" + name + "': " + hint);
}

PlayRange chosen_stretch(const std::optional<std::string>& name, const SceneView& scene)
{
    if (!name)
        return play_range_of(scene);
    require_clip(*name, scene);
    return play_range_of(*scene.clip(*name));
}

}

void declare_play_options(CLI::App& app, PlayOptions& options)
{
    const OptionHeading heading{app, option_group::play};
    app.add_option("--clip", options.clip, "Play this clip instead of the whole scene")->type_name("NAME");
    app.add_option_function<std::string>(
           "--speed", [&options](const std::string& text) { options.speed = read_speed("--speed", text); },
           "Play so many times as fast: 0.5, 2, or -1 for backwards")
        ->type_name("FACTOR");
}

Timeline chosen_timeline(const PlayOptions& options, const SceneView& scene)
{
    return {scene.frame_rate(), chosen_stretch(options.clip, scene), options.speed};
}

void require_clip(const std::string& name, const SceneView& scene)
{
    if (!scene.clip(name))
        refuse_clip(name, scene);
}

}
