#include "host/svg/read_svg.hpp"

#include "host/program/failure.hpp"
#include "host/svg/elements/part_reader.hpp"
#include "host/svg/markup/length.hpp"
#include "host/svg/markup/svg_text.hpp"
#include "host/svg/poses/layer_keys.hpp"
#include "host/svg/poses/part_match.hpp"
#include "host/svg/poses/pose_document.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

namespace {

void check_times(std::size_t drawings, std::span<const double> times)
{
    constexpr double last = 1'000'000;
    if (drawings == 0)
        throw Failure("no drawings are named: key drawings are one file for each key");
    if (drawings != times.size())
        throw Failure(std::to_string(drawings) + " key drawings but " + std::to_string(times.size()) +
                      " times: name a time for each of them");
    double before = -1;
    for (const double time : times) {
        if (!(time >= 0 && time <= last))
            throw Failure("the time of a key drawing is not within 0 and 1000000 frames");
        if (before >= 0 && !(time > before))
            throw Failure("the times of key drawings do not rise: each is later than the one before it");
        before = time;
    }
}

Picture picture_of(const SourceText& source, art::Budget& budget, art::Losses& losses)
{
    const auto text = parsed(source);
    try {
        return PartReader{drawing_of(text), {}, budget, losses}.read();
    } catch (const Failure& failure) {
        throw Failure(source.name + ": " + failure.what());
    }
}

}

art::Document read_svg_keys(std::span<const SourceText> drawings, std::span<const double> times,
                            const KeyOptions& options, art::Losses& losses, std::vector<std::string>& notes)
{
    check_times(drawings.size(), times);
    art::Budget budget;
    std::optional<Picture> canvas;
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < drawings.size(); ++i) {
        Picture picture = picture_of(drawings[i], budget, losses);
        poses.push_back({times[i], options.ease, std::move(picture.root)});
        if (!canvas)
            canvas = std::move(picture);
        else if (picture.width != canvas->width || picture.height != canvas->height)
            losses.add({"other size of the canvas in " + drawings[i].name,
                        {},
                        times[i],
                        "the size of the first one"});
    }
    if (std::string hint = match_hint(poses); !hint.empty())
        notes.push_back(std::move(hint));
    return document_of(*canvas, std::move(poses), options, budget, losses);
}

}
