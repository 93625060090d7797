#include "host/commands/flash/missing_names.hpp"

#include "host/commands/inputs/input_names.hpp"
#include "host/commands/text/clip_names.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <set>
#include <string_view>

namespace kfast {
namespace {

using Names = std::set<std::string_view>;

/// Of the controls whose actions `are_meant`.
Names names_of_controls(const BoardSettings& settings, bool (*are_meant)(ControlAction))
{
    Names names;
    for (const Control& control : settings.controls)
        if (control.kind != ControlKind::none && are_meant(control.action) && !control.name.view().empty())
            names.insert(control.name.view());
    return names;
}

Names named_clips(const BoardSettings& settings)
{
    Names names = names_of_controls(settings, has_clip);
    if (!settings.clip.view().empty())
        names.insert(settings.clip.view());
    return names;
}

/// `known` are those of the scene.
std::string hint(std::string_view name, std::string_view what, const std::vector<std::string_view>& known)
{
    return known.empty() ? "the scene has no " + std::string{what} + 's' : visible(suggestion(name, known));
}

std::string missing_clip(std::string_view name, const SceneView& scene)
{
    return "there is no clip " + in_quotes(name) +
           ", the whole scene will play in its place: " + hint(name, "clip", clip_names(scene));
}

bool has_number(const SceneView& scene, std::string_view input)
{
    const auto number = scene.input(input);
    return number && (scene.number_inputs() >> *number & 1U) != 0;
}

std::string missing_input(std::string_view name, const SceneView& scene)
{
    return "there is no " + std::string{scene.input(name) ? "number among the inputs called " : "input "} +
           in_quotes(name) + ", its button or knob will do nothing: " +
           hint(name, "input", input_names(scene, InputType::number));
}

}

std::vector<std::string> missing_names(const BoardSettings& settings, const SceneView& scene)
{
    std::vector<std::string> found;
    for (const std::string_view name : named_clips(settings))
        if (!scene.clip(name))
            found.push_back(missing_clip(name, scene));
    for (const std::string_view name : names_of_controls(settings, has_input))
        if (!has_number(scene, name))
            found.push_back(missing_input(name, scene));
    return found;
}

}
