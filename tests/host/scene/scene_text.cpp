#include "tests/host/scene/scene_text.hpp"

#include "host/kdl/parser.hpp"
#include "host/scene/scene_reader.hpp"

#include <array>
#include <sstream>
#include <variant>

namespace kfast::test {
namespace {

/// `lines` and `columns` are what stands in front of the text that a test sees.
std::string findings_text(const Diagnostics& diagnostics, std::string_view text, std::size_t lines,
                          std::size_t columns)
{
    std::string all;
    for (const Diagnostic& found : diagnostics.sorted()) {
        const LineColumn at = line_column(text, found.place.offset);
        all += all.empty() ? "" : "\n";
        all += std::to_string(at.line - lines) + ':' + std::to_string(at.column - columns);
        all += found.severity == Severity::error ? " error: " : " warning: ";
        all += found.message + (found.hint.empty() ? "" : " (" + found.hint + ')');
    }
    return all;
}

SceneText read_between(std::string before, std::string_view text, std::string_view after, std::size_t lines,
                       std::size_t columns, const std::optional<std::string>& folder = std::nullopt)
{
    const SourceText source{"test.kfast", before.append(text).append(after), folder};
    Diagnostics diagnostics;
    const kdl::Document document = kdl::parse(source.text, diagnostics);
    SceneText result;
    result.scene = scene::read_scene(document, source, diagnostics);
    result.findings = findings_text(diagnostics, source.text, lines, columns);
    return result;
}

void write(std::ostream& out, scene::Point point) { out << ' ' << point.x / 16.0 << ' ' << point.y / 16.0; }

std::string drawing_and_findings(const SceneText& text)
{
    const std::string drawing = text.scene ? text_of(key_at(*text.scene).drawing) : "";
    const bool both = !drawing.empty() && !text.findings.empty();
    return drawing + (both ? "\n" : "") + text.findings;
}

constexpr std::array<std::string_view, property_count> property_names{
    "x",       "y",         "z",       "rotation_x",  "rotation_y", "rotation",    "scale_x", "scale_y",
    "pivot_x", "pivot_y",   "along",   "opacity",     "order",      "visible",     "fill",    "stroke",
    "width",   "trim_from", "trim_to", "trim_offset", "trim",       "dash_offset", "dash_1",  "gap_1",
    "dash_2",  "gap_2",     "dash_3",  "gap_3",       "max_dashes"};

std::string text_of(const VelocityLaw& law)
{
    constexpr std::array<std::string_view, 7> names{
        "constant", "accelerate", "decelerate", "accelerate-decelerate", "hold", "steps", "bezier"};
    return std::string{names.at(static_cast<std::size_t>(law.kind))};
}

std::string frames_of(Time time)
{
    std::ostringstream out;
    out << time.ticks / 1024.0;
    return out.str();
}

std::string text_of(const scene::TrackKey& key)
{
    std::string text = frames_of(key.time) + ':' + std::to_string(key.value);
    if (key.laws != LawPair{})
        text += '(' + text_of(key.laws.x) + ',' + text_of(key.laws.y) + ')';
    return text;
}

std::string text_of(const scene::Track& track)
{
    std::string text{property_names.at(static_cast<std::size_t>(track.property))};
    text += track.is_smooth ? "~[" : "[";
    if (track.keys.size() == 1 && track.keys[0].time == Time{})
        return text + std::to_string(track.keys[0].value) + ']';
    for (const scene::TrackKey& key : track.keys)
        text.append(text.back() == '[' ? "" : " ").append(text_of(key));
    return text + ']';
}

std::string text_of(const std::vector<scene::TrackKey>& keys)
{
    std::string text;
    for (const scene::TrackKey& key : keys)
        text.append(text.empty() ? "[" : " ").append(text_of(key));
    return text + ']';
}

constexpr std::array<std::string_view, bone_quantity_count> quantity_names{"angle", "x", "y", "length"};

std::string text_of(const std::vector<scene::Bone>& bones)
{
    std::string text;
    for (const scene::Bone& bone : bones) {
        text.append(text.empty() ? "" : "\n").append(bone.name);
        if (bone.parent)
            text += " <" + bones.at(*bone.parent).name;
        text += bone.is_at_tip ? " tip" : "";
        for (const std::int32_t value : bone.set_up)
            text += ' ' + std::to_string(value);
        for (std::size_t i = 0; i < bone.keys.size(); ++i)
            if (!bone.keys[i].empty())
                text.append(1, ' ').append(quantity_names[i]).append(text_of(bone.keys[i]));
    }
    return text;
}

std::string text_of(const scene::Binding& binding, const std::vector<scene::Bone>& bones)
{
    std::string text;
    for (const scene::BoneWeight& share : binding) {
        text.append(text.empty() ? "" : "|").append(bones.at(share.bone).name);
        if (&share != binding.data())
            text += ':' + (share.weight % 256 == 0 ? std::to_string(share.weight / 256)
                                                   : std::to_string(share.weight) + "/65536");
    }
    return text;
}

std::string both(std::string text, const std::string& findings)
{
    text.append(!text.empty() && !findings.empty() ? "\n" : "").append(findings);
    return text;
}

std::string key_times(const scene::Object& object)
{
    std::string text;
    for (const scene::Key& key : object.keys)
        text.append(text.empty() ? " @" : ",").append(frames_of(key.time));
    return text;
}

class ItemsText {
public:
    explicit ItemsText(const scene::Scene& scene) : scene_{scene} {}

    void write(const std::vector<scene::Item>& items, const std::string& indent)
    {
        for (const scene::Item& item : items)
            write(item, indent);
    }

    std::string text;

private:
    void write(const scene::Item& item, const std::string& indent)
    {
        text.append(text.empty() ? "" : "\n").append(indent).append(head(item));
        for (const scene::Track& track : item.tracks)
            text += ' ' + text_of(track);
        if (item.path)
            text += (item.path->turns ? " turning(" : " path(") + test::text_of({{item.path->stroke}}) + ')';
        if (const auto* const group = std::get_if<scene::Group>(&item.content))
            write(group->items, indent + "  ");
    }

    std::string head(const scene::Item& item) const
    {
        if (const auto* const object = std::get_if<scene::Object>(&item.content))
            return "object " + item.name + key_times(*object);
        if (const auto* const use = std::get_if<scene::Use>(&item.content))
            return "use " + scene_.symbols.at(use->symbol).name;
        return item.name.empty() ? "group" : "group " + item.name;
    }

    const scene::Scene& scene_;
};

}

const scene::Object& object_at(const scene::Scene& scene, std::size_t index)
{
    return std::get<scene::Object>(scene.items.at(index).content);
}

const scene::Key& key_at(const scene::Scene& scene, std::size_t index)
{
    return object_at(scene).keys.at(index);
}

std::string text_of(const scene::Scene& scene, const std::vector<scene::Item>& items)
{
    ItemsText all{scene};
    all.write(items, "");
    return all.text;
}

std::string items_read(std::string_view text)
{
    const auto [scene, findings] = read_between("kfast 1\ncanvas 100 100\n", text, "", 2, 0);
    const std::string items = scene ? text_of(*scene, scene->items) : "";
    const bool both = !items.empty() && !findings.empty();
    return items + (both ? "\n" : "") + findings;
}

std::string bones_read(std::string_view text, std::string_view properties)
{
    const auto [scene, findings] =
        read_between("kfast 1\ncanvas 100 100\nbones s " + std::string{properties} + " {\n", text,
                     "\n}\nobject o fill=white skin=s { empty }", 3, 0);
    return both(scene ? text_of(scene->bones.at(0).bones) : "", findings);
}

std::string skin_read(std::string_view text)
{
    const auto [scene, findings] =
        read_between("kfast 1\ncanvas 100 100\n"
                     "bones s { bone a 20 80 20 40 region=10 { bone b 20 40 60 40 region=10 } }\n",
                     text, "", 3, 0);
    std::string bindings;
    if (scene && object_at(*scene).skin)
        for (const scene::Binding& binding : object_at(*scene).skin->bindings)
            bindings.append(bindings.empty() ? "" : " ").append(text_of(binding, scene->bones.at(0).bones));
    return both(bindings, findings);
}

SceneText read(std::string_view text) { return read_between("", text, "", 0, 0); }

SceneText read_on_canvas(std::string_view text)
{
    return read_between("kfast 1\ncanvas 100 100\n", text, "", 0, 0);
}

std::string text_of(const scene::Drawing& drawing)
{
    std::ostringstream out;
    out.precision(10);
    for (const scene::Stroke& stroke : drawing.strokes) {
        out << (&stroke == drawing.strokes.data() ? "M" : " M");
        write(out, stroke.from);
        for (const scene::Segment& segment : stroke.segments) {
            out << (segment.cubic ? " C" : " L");
            if (segment.cubic) {
                write(out, segment.c1);
                write(out, segment.c2);
            }
            write(out, segment.to);
        }
    }
    return out.str();
}

std::string drawn(std::string_view shape) { return drawn_in(std::nullopt, shape); }

std::string drawn_in(const std::optional<std::string>& folder, std::string_view shape)
{
    return drawing_and_findings(read_between("kfast 1\ncanvas 100 100\nobject o fill=white stroke=white {\n",
                                             shape, "\n}", 3, 0, folder));
}

std::string path_drawn(std::string_view data)
{
    constexpr std::string_view before = "path \"";
    return drawing_and_findings(
        read_between("kfast 1\ncanvas 100 100\nobject o fill=white {\n" + std::string{before}, data, "\"\n}",
                     3, before.size()));
}

}
