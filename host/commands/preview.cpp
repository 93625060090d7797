#include "host/commands/audio_options.hpp"
#include "host/commands/command.hpp"
#include "host/commands/import_options.hpp"
#include "host/commands/picture_options.hpp"
#include "host/commands/play_options.hpp"
#include "host/preview/headless.hpp"
#include "host/preview/picture_window.hpp"
#include "host/preview/terminal.hpp"
#include "host/preview/window.hpp"
#include "host/scene_file.hpp"

#include <algorithm>
#include <iostream>
#include <sstream>

namespace kfast {
namespace {

struct PreviewOptions {
    std::string file;
    bool terminal = false;
    bool headless = false;
    std::optional<int> loops;
    std::optional<std::vector<PreviewKey>> script;
    PlayOptions play;
    PictureOptions picture;
    AudioOptions audio;
};

std::vector<PreviewKey> read_script(const std::string& text)
{
    std::vector<PreviewKey> script;
    std::istringstream words{text};
    for (std::string word; words >> word;) {
        const std::optional<PreviewKey> key = preview_key(word);
        if (!key)
            throw CLI::ValidationError("--keys",
                                       "'" + word + "' is no key: write them like \"n p space right\"");
        script.push_back(*key);
    }
    return script;
}

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

void preview_headless(const PreviewOptions& options, FrameSource& source, const Programme& programme)
{
    if (options.script)
        play_script(source, programme, *options.script, std::cout);
    else
        play_headless(source, programme, std::cout);
}

void preview(const PreviewOptions& options)
{
    const SceneFile scene = load_scene(options.file);
    const Programme programme =
        chosen_programme(options.play, scene.view, chosen_inputs(options.picture.inputs, scene.view));
    const auto source = heard(open_source(options.picture, scene), options.audio, options.picture, scene);
    if (options.headless)
        return preview_headless(options, *source, programme);
    if (!options.terminal && play_in_window(*source, programme, options.file, options.loops))
        return;
    if (!options.terminal)
        std::cerr << "kfast: " << PictureWindow::no_window() << ", so this plays in the terminal\n";
    play_in_terminal(*source, programme, options.loops.value_or(1));
}

std::string key_list()
{
    std::string text = "Keys of the window, the terminal and --keys:";
    for (const std::string& line : preview_key_help())
        text += "\n  " + line;
    return text;
}

void declare(CLI::App& app)
{
    const auto options = std::make_shared<PreviewOptions>();
    app.add_option("FILE", options->file, loaded_scene)->required();
    CLI::Option* terminal =
        app.add_flag("--terminal", options->terminal, "Play in the terminal, not in a window");
    CLI::Option* loops =
        app.add_option("--loops", options->loops,
                       "Ends after so many plays (default: a window stays, the terminal plays once)")
            ->type_name("N")
            ->check(CLI::Range(1, 1000000));
    CLI::Option* headless =
        app.add_flag("--headless", options->headless, "Show nothing; print the events and a summary");
    headless->excludes(terminal)->excludes(loops)->excludes(declare_audio_options(app, options->audio));
    app.add_option_function<std::string>(
           "--keys", [options](const std::string& text) { options->script = read_script(text); },
           "With --headless: press these keys, print what each shows")
        ->type_name("LIST")
        ->needs(headless);
    declare_play_options(app, options->play);
    declare_seen_options(app, options->picture);
    app.footer(app.get_footer() + "\n\n" + key_list());
    app.callback([options] { preview(*options); });
}

}

const Command preview_command{"preview", "Play a scene in a window, in the terminal, or unseen",
                              "kfast preview eyes.kfast --size 128x64 --format mono1\n"
                              "  kfast preview eyes.kfast --headless --keys \"n n p right\"",
                              declare};

}
