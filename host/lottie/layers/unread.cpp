#include "host/lottie/layers/unread.hpp"

#include "host/lottie/values/loops.hpp"
#include "host/text/characters.hpp"

#include <array>
#include <string_view>

namespace kfast::lottie {
namespace {

constexpr std::array<std::string_view, 17> blend_modes{
    "normal",       "multiply",    "screen",     "overlay",    "darken",     "lighten",
    "colour dodge", "colour burn", "hard light", "soft light", "difference", "exclusion",
    "hue",          "saturation",  "colour",     "luminosity", "add"};

/// Members that are read somewhere, or change nothing visible.
constexpr std::string_view known_members =
    " ao au bm bounds cix cl cm color comment completed cp ct ddd ef en h hasMask hd hix id "
    "ind ip ix ks layerId layers ln masksProperties mb meta mn mode nm np op parent pe refId "
    "sc sh shapes sr st sw sy t td tg tm tp tt ty uid ver w xt ";

void report(const Reading& reading, const std::string& feature, const std::string& instead)
{
    reading.losses.add({feature, reading.layer, std::nullopt, instead});
}

std::string naming(const Json& thing)
{
    const Json* const name = find_member(thing, "nm");
    if (!name || !name->is_string())
        return {};
    return std::string{" "} + in_quotes(name->get<std::string>());
}

/// Sliders and the like, which only expressions use, draw nothing.
bool is_control(const Json& effect)
{
    const Json* const given = find_member(effect, "mn");
    const std::string match = given && given->is_string() ? given->get<std::string>() : "";
    return match.ends_with(" Control") || match.starts_with("Pseudo/");
}

void report_effects(const Json& layer, const Reading& reading)
{
    if (!find_member(layer, "ef"))
        return;
    for (const Json& effect : array_at(layer, "ef"))
        if (truth_at(effect, "en", true) && !is_control(effect))
            report(reading, std::string{"effect"} + naming(effect), "the layer is drawn without it");
}

void report_styles(const Json& layer, const Reading& reading)
{
    if (!find_member(layer, "sy"))
        return;
    for (const Json& style : array_at(layer, "sy"))
        report(reading, std::string{"layer style"} + naming(style), "the layer is drawn without it");
}

void report_blend_mode(const Json& layer, const Reading& reading)
{
    const int mode = whole_at(layer, "bm", 0);
    if (mode == 0)
        return;
    const bool known = mode > 0 && static_cast<std::size_t>(mode) < blend_modes.size();
    report(reading,
           std::string{"blend mode "} +
               (known ? std::string{blend_modes[static_cast<std::size_t>(mode)]} : std::to_string(mode)),
           "the layer covers what lies below");
}

void report_unknown(const Json& layer, const Reading& reading)
{
    for (const auto& [name, member] : layer.items())
        if (known_members.find(' ' + name + ' ') == std::string_view::npos)
            report(reading, std::string{"member "} + in_quotes(name), "it is not looked at");
}

/// A property may refer to a value of the file that users of it override.
void report_slot(const Json& part, const std::string& path, const Animation& animation,
                 const Reading& reading)
{
    const Json* const slots = find_member(animation.root, "slots");
    const Json* const id = find_member(part, "sid");
    if (slots && id && id->is_string() && slots->contains(id->get_ref<const std::string&>()))
        report(reading, "slot " + in_quotes(id->get<std::string>()) + " of " + path,
               "the value that stands beside its name");
}

bool is_expression(const Json& part)
{
    const Json* const text = find_member(part, "x");
    return text && text->is_string() && part.contains("k") && !read_loop(part);
}

}

void report_expressions(const Json& part, const std::string& path, Animation& animation,
                        const Reading& reading)
{
    if (part.is_object() && is_expression(part))
        report(reading, std::string{"expression of "} + path, "its value without the expression");
    if (part.is_object()) {
        report_slot(part, path, animation, reading);
        for (const auto& [name, member] : part.items())
            if (member.is_structured() && name != "ef" && name != "sy")
                report_expressions(member, path.empty() ? std::string{name} : path + '.' + name, animation,
                                   reading);
    } else if (part.is_array()) {
        for (std::size_t i = 0; i < part.size(); ++i)
            if (part[i].is_structured())
                report_expressions(part[i], path + '[' + std::to_string(i) + ']', animation, reading);
    }
}

void report_unread(const Json& layer, Animation& animation, const Reading& reading)
{
    if (!animation.looked_through.insert(&layer).second)
        return;
    report_blend_mode(layer, reading);
    report_effects(layer, reading);
    report_styles(layer, reading);
    if (truth_at(layer, "mb", false))
        report(reading, "motion blur", "sharp edges");
    report_unknown(layer, reading);
    report_expressions(layer, "", animation, reading);
}

}
