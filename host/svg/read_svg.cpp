#include "host/svg/read_svg.hpp"

#include "host/program/failure.hpp"
#include "host/svg/elements/part_reader.hpp"
#include "host/svg/markup/shortened.hpp"
#include "host/svg/markup/svg_text.hpp"
#include "host/svg/poses/layer_keys.hpp"
#include "host/svg/poses/pose_document.hpp"

#include <algorithm>
#include <utility>

namespace kfast::svg {
namespace {

Failure of_file(const SourceText& source, const Failure& failure)
{
    return Failure{source.name + ": " + failure.what()};
}

std::string layers_note(const std::vector<KeyLayer>& layers)
{
    constexpr std::size_t max = 8;
    std::string names;
    for (std::size_t i = 0; i < std::min(layers.size(), max); ++i)
        names += (i == 0 ? "\"" : ", \"") + shortened(layers[i].name) + '"';
    return "the layers " + names + (layers.size() > max ? ", ..." : "") +
           " are key drawings, by their names: --layers never draws them over each other";
}

art::Document document_of(const pugi::xml_document& text, const KeyOptions& options, art::Losses& losses,
                          std::vector<std::string>& notes)
{
    art::Budget budget;
    const auto layers = key_layers(drawing_of(text), options);
    std::vector<pugi::xml_node> shown;
    shown.reserve(layers.size());
    for (const KeyLayer& layer : layers)
        shown.push_back(layer.element);
    if (!layers.empty() && options.layers == LayerKeys::automatic)
        notes.push_back(layers_note(layers));
    Picture picture = PartReader{drawing_of(text), shown, budget, losses}.read();
    std::vector<Pose> poses;
    if (layers.empty())
        poses.push_back({0, options.ease, std::move(picture.root)});
    else
        poses = poses_of(picture.root, layers, options);
    return document_of(picture, std::move(poses), options, budget, losses);
}

}

art::Document read_svg(const SourceText& source, const KeyOptions& options, art::Losses& losses,
                       std::vector<std::string>& notes)
{
    const auto text = parsed(source);
    try {
        return document_of(text, options, losses, notes);
    } catch (const Failure& failure) {
        throw of_file(source, failure);
    }
}

art::Document read_svg(const SourceText& source, const KeyOptions& options, art::Losses& losses)
{
    std::vector<std::string> dropped_notes;
    return read_svg(source, options, losses, dropped_notes);
}

art::Document read_svg(const SourceText& source, art::Losses& losses) { return read_svg(source, {}, losses); }

}
