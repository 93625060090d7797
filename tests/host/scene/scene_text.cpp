#include "tests/host/scene/scene_text.hpp"

#include "host/kdl/parser.hpp"
#include "host/scene/scene_reader.hpp"

#include <sstream>

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
        all += found.message + (found.remedy.empty() ? "" : " (" + found.remedy + ')');
    }
    return all;
}

SceneText read_between(std::string before, std::string_view text, std::string_view after, std::size_t lines,
                       std::size_t columns)
{
    const SourceText source{"test.kfast", before.append(text).append(after)};
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
    const std::string drawing = text.scene ? text_of(text.scene->objects.at(0).keys.at(0).drawing) : "";
    const bool both = !drawing.empty() && !text.findings.empty();
    return drawing + (both ? "\n" : "") + text.findings;
}

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

std::string drawn(std::string_view shape)
{
    return drawing_and_findings(
        read_between("kfast 1\ncanvas 100 100\nobject o fill=white {\n", shape, "\n}", 3, 0));
}

std::string path_drawn(std::string_view data)
{
    constexpr std::string_view before = "path \"";
    return drawing_and_findings(
        read_between("kfast 1\ncanvas 100 100\nobject o fill=white {\n" + std::string{before}, data, "\"\n}",
                     3, before.size()));
}

}
