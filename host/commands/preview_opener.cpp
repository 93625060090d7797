#include "host/commands/preview_opener.hpp"

#include "host/commands/input_names.hpp"
#include "host/failure.hpp"
#include "host/fit/board_choice.hpp"
#include "host/preview/programme.hpp"

#include <algorithm>
#include <iostream>
#include <sstream>
#include <utility>
#include <vector>

namespace kfast {
namespace {

namespace fs = std::filesystem;

Programme chosen_programme(const PlayOptions& options, const SceneView& scene,
                           const std::vector<InputValue>& inputs)
{
    Programme programme = programme_of(scene);
    programme.speed = chosen_timeline(options, scene).speed;
    const auto first = std::ranges::find(programme.parts, options.clip.value_or(""), &Part::name);
    for (InputKnob& input : programme.inputs) {
        input.value = inputs[input.number].number;
        input.text = inputs[input.number].text;
    }
    programme.first = static_cast<std::size_t>(first - programme.parts.begin());
    return programme;
}

/// The files of --drawing.
std::vector<fs::path> drawing_files(const DrawingOptions& options, const SceneView& scene)
{
    std::vector<fs::path> files;
    for (const std::string& text : options.texts)
        files.emplace_back(text.substr(end_of_input_name(text, scene) + 1));
    return files;
}

std::unique_ptr<OpenedScene> opened(const PreviewChoice& choice, const fs::path& file, SceneFile scene)
{
    const PictureOptions& picture = choice.picture;
    const SceneView view = scene.view;
    Programme programme = chosen_programme(choice.play, view, chosen_inputs(picture.inputs, view));
    auto opened = std::make_unique<OpenedScene>(OpenedScene{.file = file,
                                                            .scene = std::move(scene),
                                                            .source = {},
                                                            .programme = std::move(programme),
                                                            .panel = {}});
    opened->source = heard(open_source(picture, opened->scene), choice.audio, picture, opened->scene);
    opened->panel = opened->source->show(Time{0}).size;
    opened->fit = picture.fit;
    opened->is_beam = picture.screen.beam.has_value();
    if (picture.panel != nullptr) {
        opened->is_round = picture.panel->settings.controller == Controller::gc9a01;
        opened->panel_name = picture.panel->name;
    }
    if (choice.board)
        opened->board = fit::chosen_board(*choice.board);
    opened->tell_drawings = [drawings = picture.drawings, view](ToldInputs& told) {
        put_drawings(drawings, view, told);
    };
    opened->also_read = drawing_files(picture.drawings, view);
    return opened;
}

PreviewChoice without_what_is_named(PreviewChoice choice)
{
    choice.play.clip.reset();
    choice.picture.inputs = {};
    choice.picture.drawings = {};
    return choice;
}

std::unique_ptr<OpenedScene> open_as_far_as_it_suits(const PreviewChoice& choice, const fs::path& file,
                                                     std::ostream& out)
{
    try {
        return opened(choice, file, load_scene(file, {}, out));
    } catch (const CLI::ValidationError& mistake) {
        out << mistake.what() << ", so --clip, --input and --drawing are left out\n";
    }
    std::ostringstream again; // says the same
    return opened(without_what_is_named(choice), file, load_scene(file, {}, again));
}

}

std::unique_ptr<OpenedScene> open_preview(const PreviewChoice& choice, const fs::path& file)
{
    return opened(choice, file, load_scene(file));
}

Opener preview_opener(const PreviewChoice& choice)
{
    return [choice](const fs::path& file) {
        std::ostringstream found;
        try {
            auto opened = open_as_far_as_it_suits(choice, file, found);
            opened->warnings = found.str();
            return opened;
        } catch (const std::exception& failure) {
            throw Failure(found.str() + failure.what());
        }
    };
}

}
