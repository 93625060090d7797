#include "host/commands/render/preview_opener.hpp"

#include "host/commands/options/option_groups.hpp"
#include "host/commands/render/picture_options.hpp"
#include "host/file/input_file.hpp"
#include "host/fit/board_choice.hpp"
#include "host/preview/board/previewed_board.hpp"
#include "host/preview/playback/playback_setup.hpp"
#include "host/program/failure.hpp"
#include "host/sound/beam_sound.hpp"
#include "host/sound/sound_card.hpp"
#include "host/text/reported_diagnostics.hpp"

#include <algorithm>
#include <iostream>
#include <sstream>
#include <utility>
#include <vector>

namespace kfast {

namespace {

void list_devices()
{
    const std::vector<std::string> names = SoundCard::names();
    if (names.empty())
        std::cout << "there is no sound card\n";
    for (const std::string& name : names)
        std::cout << name << '\n';
    throw CLI::Success{};
}

}

CLI::Option* declare_audio_options(CLI::App& app, AudioOptions& options)
{
    const OptionHeading heading{app, option_group::sound};
    CLI::Option* audio = app.add_flag("--audio", options.is_heard,
                                      "Lead an oscilloscope on the sound card too: x left, y right");
    app.add_option("--audio-device", options.device, "Which sound card (default: the usual one)")
        ->type_name("NAME")
        ->needs(audio);
    app.add_flag_callback("--audio-devices", list_devices, "List the sound cards, and do nothing else")
        ->trigger_on_parse();
    for (CLI::Option* option : declare_sound_options(app, options.sound))
        option->needs(audio);
    return audio;
}

BeamProfile heard_profile(const AudioOptions& audio, const std::optional<ChosenBeam>& beam)
{
    return sound_beam(beam ? std::optional{beam->profile} : std::nullopt, audio.sound.rate);
}

std::shared_ptr<LedBeam> opened_sound(const AudioOptions& audio, const BeamProfile& profile)
{
    return std::make_shared<LedBeam>(profile, audio.sound.deflection, audio.device);
}

namespace {

namespace fs = std::filesystem;

PlaybackSetup chosen_setup(const PlayOptions& options, const SceneView& scene,
                           const std::vector<InputValue>& inputs)
{
    PlaybackSetup playback_setup = playback_setup_of(scene);
    playback_setup.speed = chosen_timeline(options, scene).speed;
    const auto first = std::ranges::find(playback_setup.parts, options.clip.value_or(""), &Part::name);
    for (InputKnob& input : playback_setup.inputs) {
        input.value = inputs[input.number].number;
        input.text = inputs[input.number].text;
    }
    playback_setup.first = static_cast<std::size_t>(first - playback_setup.parts.begin());
    return playback_setup;
}

/// The beam on the screen of the ready profile that is nearest.
ChosenBeam on_screen(const BeamProfile& beam)
{
    const auto ready = std::ranges::find(profile_choices(), beam, &ProfileChoice::profile);
    if (ready != profile_choices().end())
        return {beam, ready->name};
    return {beam, beam.is_laser ? "galvo" : "scope"};
}

/// Where the options name no display, that of the board.
void choose_display(PictureOptions& options, const fit::Target& board)
{
    if (options.panel != nullptr || options.screen.beam)
        return;
    if (board.beam && !options.format)
        options.screen.beam = on_screen(*board.beam);
    if (board.beam)
        return;
    options.size = options.size.value_or(board.display.size);
    options.format = options.format.value_or(board.display.format);
}

ShownDisplay shown_display(const PictureOptions& options, Size panel)
{
    ShownDisplay shown{.size = panel, .format = options.format};
    if (options.panel != nullptr)
        shown.controller = options.panel->name;
    if (options.screen.beam)
        shown.beam = options.screen.beam->profile;
    return shown;
}

bool is_round_glass(const fit::Display& display)
{
    const fit::Display* const round = fit::display_named("gc9a01");
    return display.name == round->name && display.size == round->size;
}

template <class Check>
bool is_known(const Check& check, std::ostream& out)
{
    try {
        check();
        return true;
    } catch (const CLI::ValidationError& mistake) {
        out << mistake.what() << ", so that is left out\n";
        return false;
    }
}

PreviewChoice without_unknown_names(PreviewChoice choice, const SceneView& scene, std::ostream& out)
{
    if (choice.play.clip && !is_known([&] { require_clip(*choice.play.clip, scene); }, out))
        choice.play.clip.reset();
    std::erase_if(choice.picture.inputs.texts, [&](const std::string& text) {
        return !is_known([&] { require_input(text, scene); }, out);
    });
    std::erase_if(choice.picture.drawings.texts, [&](const std::string& text) {
        return !is_known([&] { require_drawing(text, scene); }, out);
    });
    return choice;
}

SceneFile empty_scene(const fs::path& file)
{
    std::ostringstream discarded;
    return scene_of(file, "kfast 1\ncanvas 240 240\n", {}, printing_to(discarded), discarded);
}

}

/// Of one scene and of what belongs to it.
struct PreviewOpener::Reading {
    fs::path file;
    std::ostream& out;
    Reporter reporter = printing_to(out);
    FileWatch read = {};

    SceneFile scene()
    {
        read.add(file);
        SceneFile scene = scene_of(file, read_input(file, scene_input), {}, reporter, out);
        for (const fs::path& font : scene.fonts) // known only now
            read.add(font);
        return scene;
    }

    std::optional<fit::Target> board(const std::optional<std::string>& name)
    {
        if (!name)
            return std::nullopt;
        if (fit::names_board_file(*name))
            read.add(*name);
        return fit::chosen_board(*name, out);
    }

    InputValues inputs(const PictureOptions& options, const SceneView& view)
    {
        for (const std::string& text : options.drawings.texts)
            read.add(drawing_file(text, view));
        return chosen_values(options.inputs, options.drawings, view);
    }

    /// Updates it from its file.
    void refresh(std::optional<ChosenBeam>& beam)
    {
        if (!beam || beam->file.empty())
            return;
        read.add(beam->file);
        beam = chosen_beam(beam->file, out);
    }
};

PreviewOpener::PreviewOpener(PreviewChoice choice) : choice_{std::move(choice)} {}

std::unique_ptr<OpenedScene> PreviewOpener::open_first(const fs::path& file,
                                                       const std::function<bool()>& is_watched)
{
    std::ostringstream mistakes;
    Reading reading{file, std::cerr, [&](const Diagnostics& found, const SourceText& source) {
                        const bool is_wrong = count(found).errors > 0;
                        return report(found, source, is_wrong && is_watched() ? mistakes : std::cerr);
                    }};
    try {
        SceneFile scene = reading.scene();
        return opened(choice_, std::move(scene), reading);
    } catch (const Failure& failure) {
        if (mistakes.view().empty())
            throw;
        mistakes << failure.what();
        return empty(mistakes.str(), reading);
    }
}

std::unique_ptr<OpenedScene> PreviewOpener::empty(std::string mistakes, Reading& reading)
{
    SceneFile scene = empty_scene(reading.file);
    std::ostringstream discarded;
    const PreviewChoice choice = without_unknown_names(choice_, scene.view, discarded);
    auto empty = opened(choice, std::move(scene), reading);
    empty->mistakes = std::move(mistakes);
    return empty;
}

std::unique_ptr<OpenedScene> PreviewOpener::open_next(const fs::path& file)
{
    std::ostringstream found;
    Reading reading{file, found};
    try {
        SceneFile scene = reading.scene();
        const PreviewChoice choice = without_unknown_names(choice_, scene.view, found);
        auto next = opened(choice, std::move(scene), reading);
        next->warnings = found.str();
        return next;
    } catch (const std::exception& failure) {
        throw OpeningFailed(found.str() + failure.what(), std::move(reading.read));
    }
}

std::unique_ptr<OpenedScene> PreviewOpener::opened(const PreviewChoice& choice, SceneFile scene,
                                                   Reading& reading)
{
    PictureOptions picture = choice.picture;
    reading.refresh(picture.screen.beam);
    const auto board = reading.board(choice.board);
    if (board)
        choose_display(picture, *board);
    const SceneView view = scene.view;
    InputValues inputs = reading.inputs(picture, view);
    auto opened = std::make_unique<OpenedScene>(
        OpenedScene{.file = reading.file,
                    .scene = std::move(scene),
                    .source = {},
                    .playback_setup = chosen_setup(choice.play, view, inputs.values),
                    .panel = {},
                    .fit = picture.fit,
                    .is_beam = picture.screen.beam.has_value()});
    auto source = open_at_rest(picture, opened->scene);
    put_values(inputs, view, *source);
    opened->panel = source->show(Time{0}).size;
    if (choice.beside)
        opened->beside = std::make_shared<PanelPictures>(*choice.beside, opened->panel);
    opened->source = heard(std::move(source), picture, inputs, view);
    opened->board = previewed_board(shown_display(picture, opened->panel), board);
    opened->is_round = !opened->is_beam && is_round_glass(opened->board->display);
    if (!opened->is_beam && (picture.panel != nullptr || board))
        opened->panel_name = opened->board->display.name;
    opened->apply_drawings = [drawings = std::move(inputs.drawings), view](InputReceiver& receiver) {
        put_drawings(drawings, view, receiver);
    };
    opened->read = std::move(reading.read);
    return opened;
}

std::unique_ptr<FrameSource> PreviewOpener::heard(std::unique_ptr<FrameSource> picture,
                                                  const PictureOptions& options, const InputValues& inputs,
                                                  const SceneView& scene)
{
    if (!choice_.audio.is_heard)
        return picture;
    const BeamProfile profile = heard_profile(choice_.audio, options.screen.beam);
    if (sound_ == nullptr || sound_profile_ != profile)
        sound_ = opened_sound(choice_.audio, profile);
    sound_profile_ = profile;
    BeamSource beam{scene, profile};
    put_values(inputs, scene, beam);
    return std::make_unique<BeamSound>(std::move(picture), std::move(beam), sound_);
}

}
