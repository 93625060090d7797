#include "host/svg/read_svg.hpp"

#include "host/failure.hpp"
#include "host/svg/layer_keys.hpp"
#include "host/svg/part_reader.hpp"
#include "host/svg/pose_document.hpp"
#include "host/svg/svg_text.hpp"

#include <utility>

namespace kfast::svg {
namespace {

Failure of_file(const SourceText& source, const Failure& failure)
{
    return Failure{source.name + ": " + failure.what()};
}

art::Document document_of(const pugi::xml_document& text, const KeyOptions& options, art::Losses& losses)
{
    art::Budget budget;
    const auto layers = key_layers(drawing_of(text), options);
    std::vector<pugi::xml_node> shown;
    for (const KeyLayer& layer : layers)
        shown.push_back(layer.element);
    Picture picture = PartReader{drawing_of(text), shown, budget, losses}.read();
    std::vector<Pose> poses;
    if (layers.empty())
        poses.push_back({0, options.ease, std::move(picture.root)});
    else
        poses = poses_of(picture.root, layers, options);
    return document_of(picture, std::move(poses), options, budget, losses);
}

}

art::Document read_svg(const SourceText& source, const KeyOptions& options, art::Losses& losses)
{
    const auto text = parsed(source);
    try {
        return document_of(text, options, losses);
    } catch (const Failure& failure) {
        throw of_file(source, failure);
    }
}

art::Document read_svg(const SourceText& source, art::Losses& losses) { return read_svg(source, {}, losses); }

}
