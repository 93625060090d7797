#include "host/commands/missing_clips.hpp"

#include "host/commands/clip_names.hpp"
#include "host/text/glyph.hpp"

#include <set>
#include <string_view>

namespace kfast {
namespace {

/// Empty ones as well: where none is named.
std::set<std::string_view> named_clips(const BoardSettings& settings)
{
    std::set<std::string_view> names{settings.clip.view()};
    for (const Control& control : settings.controls)
        if (control.kind != ControlKind::none && has_clip(control.action))
            names.insert(control.clip.view());
    return names;
}

std::string there_are(const SceneView& scene)
{
    std::string list;
    for (const std::string_view name : clip_names(scene))
        list += (list.empty() ? "" : ", ") + quoted(name);
    return list.empty() ? "the scene has no clips" : "the scene has " + list;
}

}

std::vector<std::string> missing_clips(const BoardSettings& settings, const SceneView& scene)
{
    std::vector<std::string> found;
    for (const std::string_view name : named_clips(settings))
        if (!name.empty() && !scene.clip(name))
            found.push_back("there is no clip " + quoted(name) +
                            ", the whole scene will play in its place: " + there_are(scene));
    return found;
}

}
