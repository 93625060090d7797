#include "tests/host/svg/drawing_text.hpp"

#include "host/program/failure.hpp"
#include "host/svg/read_svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

std::vector<std::string> lines_of(const art::Losses& losses)
{
    std::vector<std::string> lines;
    for (const art::Loss& loss : losses.list())
        lines.push_back(loss.feature + " | " + loss.layer + " | " + loss.instead);
    return lines;
}

void require_none(const art::Losses& losses)
{
    for (const std::string& line : lines_of(losses))
        FAIL_CHECK(line);
}

art::Document read_drawings(const std::vector<std::string>& contents, const std::vector<double>& times,
                            const svg::KeyOptions& options, art::Losses& losses)
{
    std::vector<SourceText> sources;
    for (std::size_t i = 0; i < contents.size(); ++i)
        sources.push_back({"pose" + std::to_string(i) + ".svg", drawing(contents[i])});
    std::vector<std::string> notes;
    return svg::read_svg_keys(sources, times, options, losses, notes);
}

const art::Node* found(const std::vector<art::Node>& nodes, std::string_view name)
{
    for (const art::Node& node : nodes) {
        if (node.name == name)
            return &node;
        if (const auto* group = std::get_if<art::Group>(&node.content))
            if (const art::Node* inner = found(group->nodes, name))
                return inner;
    }
    return nullptr;
}

}

std::string drawing(std::string_view content, std::string_view attributes)
{
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" "
           "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" " +
           std::string{attributes} + ">\n" + std::string{content} + "\n</svg>\n";
}

art::Document read_drawing(std::string_view content, std::string_view attributes,
                           const svg::KeyOptions& options)
{
    art::Losses losses;
    art::Document document = svg::read_svg({"test.svg", drawing(content, attributes)}, options, losses);
    require_none(losses);
    return document;
}

art::Document read_lossy(std::string_view content)
{
    art::Losses losses;
    return svg::read_svg({"test.svg", drawing(content)}, losses);
}

art::Document read_drawings(const std::vector<std::string>& contents, const std::vector<double>& times,
                            const svg::KeyOptions& options)
{
    art::Losses losses;
    art::Document document = read_drawings(contents, times, options, losses);
    require_none(losses);
    return document;
}

std::vector<std::string> losses_of(std::string_view content)
{
    art::Losses losses;
    svg::read_svg({"test.svg", drawing(content)}, losses);
    return lines_of(losses);
}

std::vector<std::string> losses_of_keys(const std::vector<std::string>& contents,
                                        const std::vector<double>& times)
{
    art::Losses losses;
    read_drawings(contents, times, {}, losses);
    return lines_of(losses);
}

const art::Node& find(const art::Document& document, std::string_view name)
{
    const art::Node* const node = found(document.nodes, name);
    REQUIRE_MESSAGE(node != nullptr, std::string{name});
    return *node;
}

const art::Shape& shape(const art::Document& document, std::string_view name)
{
    return std::get<art::Shape>(find(document, name).content);
}

std::vector<double> box(const art::Drawing& drawing)
{
    std::vector<double> result{1e9, 1e9, -1e9, -1e9};
    const auto add = [&](scene::Vec2 spot) {
        const auto rounded = [](double value) { return std::round(value * 1000) / 1000 + 0.0; };
        result = {std::min(result[0], rounded(spot.x)), std::min(result[1], rounded(spot.y)),
                  std::max(result[2], rounded(spot.x)), std::max(result[3], rounded(spot.y))};
    };
    for (const scene::Outline& outline : drawing.outlines) {
        add(outline.from);
        for (const scene::Curve& curve : outline.curves)
            add(curve.to);
    }
    return result;
}

std::string hex(const art::Rgb& colour)
{
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x",
                  static_cast<unsigned>(std::lround(255 * colour.red)) & 0xFF,
                  static_cast<unsigned>(std::lround(255 * colour.green)) & 0xFF,
                  static_cast<unsigned>(std::lround(255 * colour.blue)) & 0xFF);
    return text;
}

std::string failure_of(const std::string& text, const svg::KeyOptions& options)
{
    art::Losses losses;
    try {
        svg::read_svg({"test.svg", text}, options, losses);
    } catch (const Failure& failure) {
        return failure.what();
    }
    return {};
}

}
