#include "host/preview/window/side_contents.hpp"

#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace kfast {
namespace {

/// With at most three digits after the point.
std::string number_text(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%g", std::round(number * 1000) / 1000);
    return text;
}

std::string display_text(const OpenedScene& scene)
{
    std::string text = std::to_string(scene.panel.width) + " x " + std::to_string(scene.panel.height);
    if (!scene.panel_name.empty())
        text += ", " + scene.panel_name;
    return text;
}

std::string zoom_text(double scale)
{
    return scale < 1 ? number_text(std::round(scale * 100)) + " %" : number_text(scale) + "x";
}

void add_scene(SidePanel& panel, const OpenedScene& scene, double scale)
{
    const SceneView& view = scene.scene.view;
    const double frames = static_cast<double>(view.length().ticks) / Time::ticks_per_frame;
    const double rate = view.frame_rate() / 1000.0;
    panel.add_heading(visible(scene.file.filename().string()));
    panel.add_value("display", display_text(scene), false);
    panel.add_value("frames", number_text(frames) + " at " + number_text(rate) + "/s", false);
    panel.add_value("lasts", number_text(frames / rate) + " s", false);
    panel.add_value("shown at", zoom_text(scale), false);
}

void add_line(SidePanel& panel, const Viewer& viewer)
{
    if (const auto line = viewer.selected_line())
        panel.add_link(visible(line->file.filename().string()) + ':' + std::to_string(line->line));
}

void add_facts(SidePanel& panel, const ItemFacts& facts)
{
    for (const ItemValue& value : facts.values)
        panel.add_value(value.name, value.value, value.has_keys);
    if (!facts.ways.empty())
        panel.add_heading("keys before and after");
    for (const ItemFacts::Way& way : facts.ways) {
        panel.add(way.name);
        for (const std::string& key : {way.begin, way.end})
            if (!key.empty())
                panel.add("  " + key, theme::quiet_text);
    }
}

void add_selected(SidePanel& panel, Viewer& viewer)
{
    const TimeRow* const row = viewer.time_table().row_of(viewer.view().selected);
    panel.add_heading("selected");
    if (row == nullptr)
        return panel.add("nothing: click, or press tab", theme::quiet_text);
    panel.add_value(visible(row->name), counted(row->keys.size(), "key"), true);
    add_line(panel, viewer);
    if (const auto facts = viewer.selected_facts())
        add_facts(panel, *facts);
}

void add_input(SidePanel& panel, const InputKnob& input, bool is_chosen)
{
    if (!input.can_turn())
        return panel.add_value(visible(input.name), in_quotes(input.text), is_chosen);
    const double range = static_cast<double>(input.range.max) - input.range.min;
    const double share = (static_cast<double>(input.value) - input.range.min) / std::max(1.0, range);
    panel.add_value(visible(input.name), number_text(input.value / 1000.0), is_chosen, share);
}

void add_inputs(SidePanel& panel, const PreviewPlayback& playback)
{
    if (playback.inputs().empty())
        return;
    panel.add_heading("inputs");
    for (std::size_t i = 0; i < playback.inputs().size(); ++i)
        add_input(panel, playback.inputs()[i], playback.chosen_input() == i);
}

Colour colour_of(FitLine::Verdict verdict)
{
    switch (verdict) {
    case FitLine::Verdict::good:
        return theme::good;
    case FitLine::Verdict::bad:
        return theme::bad;
    default:
        return theme::text;
    }
}

void add_fit_report(SidePanel& panel, Viewer& viewer)
{
    if (!viewer.view().fit_report)
        return;
    panel.add_heading("does it fit?");
    const auto lines = viewer.fit_report();
    if (!lines)
        return panel.add("being found out ...", theme::quiet_text);
    for (const FitLine& line : *lines)
        panel.add(line.text, colour_of(line.verdict));
}

}

SidePanel side_contents(Viewer& viewer, double scale)
{
    SidePanel panel;
    add_scene(panel, viewer.scene(), scale);
    add_selected(panel, viewer);
    add_inputs(panel, viewer.playback());
    add_fit_report(panel, viewer);
    return panel;
}

}
