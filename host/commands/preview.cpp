#include "host/commands/command.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/option_values.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/render/preview_opener.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/fit/board_texts.hpp"
#include "host/picture/png.hpp"
#include "host/preview/files/file_dialogue.hpp"
#include "host/preview/headless.hpp"
#include "host/preview/playback/preview_playback.hpp"
#include "host/preview/terminal.hpp"
#include "host/preview/terminal/borrowed_terminal.hpp"
#include "host/preview/viewer/beside.hpp"
#include "host/preview/window.hpp"
#include "host/preview/window/picture_window.hpp"

#include <iostream>
#include <sstream>
#include <utility>

namespace kfast {
namespace {

struct PreviewOptions {
    std::string file;
    bool terminal = false;
    bool headless = false;
    std::optional<int> loops;
    std::optional<std::vector<ScriptStep>> script;
    bool board_speed = false;
    std::string snapshot;
    Size window{960, 720};
    PreviewChoice choice;
};

std::vector<ScriptStep> read_script(const std::string& text)
{
    std::vector<ScriptStep> script;
    std::istringstream words{text};
    for (std::string word; words >> word;) {
        const std::optional<ScriptStep> step = script_step(word);
        if (!step)
            throw CLI::ValidationError("--press", "'" + word +
                                                      "' is no key: write them like \"n p space right "
                                                      "frame=12 select=lamp\"");
        script.push_back(*step);
    }
    return script;
}

Opener opener_of(PreviewOpener& opener)
{
    return [&opener](const std::filesystem::path& file) { return opener.open_next(file); };
}

void preview_headless(const PreviewOptions& options, PreviewOpener& opener,
                      std::unique_ptr<OpenedScene> scene)
{
    if (!options.script && options.snapshot.empty())
        return play_headless(*scene->source, scene->playback_setup, std::cout);
    Viewer viewer{opener_of(opener), std::move(scene), Viewer::Seconds{0}};
    const auto script = options.script.value_or(std::vector<ScriptStep>{});
    if (options.snapshot.empty())
        return play_script(viewer, script, std::cout);
    write_png(options.snapshot, snapshot(viewer, script, options.window, std::cout));
    std::cout << written_picture_text(options.snapshot, "the window", options.window,
                                      written_bytes(options.snapshot))
              << '\n';
}

void preview_in_window(const PreviewOptions& options, PictureWindow& window, PreviewOpener& opener,
                       std::unique_ptr<OpenedScene> scene)
{
    Viewer viewer{opener_of(opener), std::move(scene), steady_now(), options.loops};
    viewer.let_choose(std::make_unique<FileDialogue>());
    viewer.let_edit(std::make_unique<EditorBeside>());
    viewer.play_as_board(options.board_speed, steady_now());
    play_in_window(window, viewer);
}

void preview_in_terminal(const PreviewOptions& options, PreviewOpener& opener,
                         std::unique_ptr<OpenedScene> scene)
{
    if (!can_play_in_terminal()) {
        const Picture first = widen(scene->source->show(Time{0}));
        return write_as_text(scene->beside ? joined(first, scene->beside->at(0)) : first);
    }
    Keyboard keyboard;
    const auto loops = keyboard.works() ? options.loops : options.loops.value_or(1);
    Viewer viewer{opener_of(opener), std::move(scene), steady_now(), loops};
    viewer.play_as_board(options.board_speed, steady_now());
    play_in_terminal(viewer, keyboard);
}

/// Whether somebody watches who may correct the scene meanwhile.
bool is_watched(const PreviewOptions& options)
{
    if (options.headless || options.loops)
        return false;
    const bool has_window = !options.terminal && PictureWindow::can_open();
    return has_window || (can_play_in_terminal() && Keyboard{}.works());
}

void preview(const PreviewOptions& options)
{
    if (options.choice.beside && options.headless && options.snapshot.empty())
        throw CLI::ValidationError("--beside",
                                   "--headless shows no pictures: leave one out, or add --snapshot");
    PreviewOpener opener{options.choice};
    auto scene = opener.open_first(options.file, [&options] { return is_watched(options); });
    if (options.headless)
        return preview_headless(options, opener, std::move(scene));
    if (options.terminal)
        return preview_in_terminal(options, opener, std::move(scene));
    if (const auto window = PictureWindow::open(options.file, first_window_size(scene->panel)))
        return preview_in_window(options, *window, opener, std::move(scene));
    std::cerr << "kfast: " << PictureWindow::no_window() << ", so this plays in the terminal\n";
    preview_in_terminal(options, opener, std::move(scene));
}

std::string key_list()
{
    std::string text = "Keys of the window and --press; a terminal has those that mean something there:";
    for (const std::string& line : preview_key_help(PreviewFront::window))
        text += "\n  " + line;
    return text;
}

CLI::Option* declare_showing(CLI::App& app, PreviewOptions& options)
{
    const OptionHeading heading{app, option_group::showing};
    CLI::Option* const terminal =
        app.add_flag("--terminal", options.terminal, "Play in the terminal, not in a window");
    CLI::Option* const loops =
        app.add_option(
               "--loops", options.loops,
               "Ends after so many plays (default: it stays until you quit; where nobody can type, the "
               "terminal plays once)")
            ->type_name("N")
            ->check(number_within(1, 1e6));
    CLI::Option* const beside =
        app.add_option(
               "--beside", options.choice.beside,
               "Show, right of each picture, what another panel has shown: a folder of 0000.png, 0001.png "
               "... by frames, as render --all writes it")
            ->type_name("FOLDER");
    names_folder(beside, {"..."}); // no file ends so: folders alone are offered
    CLI::Option* const board_speed = app.add_flag(
        "--board-speed", options.board_speed, "Play as slowly as the board of --board would, as key w does");
    return app.add_flag("--headless", options.headless, "Show nothing; print the events and a summary")
        ->excludes(terminal)
        ->excludes(loops)
        ->excludes(board_speed)
        ->group(option_group::unseen);
}

void declare_unseen(CLI::App& app, PreviewOptions& options, CLI::Option* headless)
{
    const OptionHeading heading{app, option_group::unseen};
    app.add_option_function<std::string>(
           "--press", [&options](const std::string& text) { options.script = read_script(text); },
           "With --headless: press these keys, print what each shows; frame=N touches the time line, "
           "select=NAME an object, open=FILE drops a file, wait=S lets seconds pass")
        ->type_name("KEYS")
        ->needs(headless);
    CLI::Option* const snapshot =
        app.add_option("--snapshot", options.snapshot,
                       "With --headless: write the window as it looks after these keys, as PNG")
            ->type_name("OUT.png")
            ->needs(headless);
    app.add_option_function<std::string>(
           "--window", [&options](const std::string& text) { options.window = read_size("--window", text); },
           "Size of the window of --snapshot (default: 960x720)")
        ->type_name("WxH")
        ->needs(snapshot);
}

void declare_preview(CLI::App& app)
{
    const auto options = std::make_shared<PreviewOptions>();
    reads_scene(app.add_option("FILE", options->file, loaded_scene))->required();
    CLI::Option* const headless = declare_showing(app, *options);
    headless->excludes(declare_audio_options(app, options->choice.audio));
    declare_unseen(app, *options, headless);
    declare_play_options(app, options->choice.play);
    declare_seen_options(app, options->choice.picture);
    app.add_option(
           "--board", options->choice.board,
           "The board of the fit report (key e), whose display is shown where no other one is named: " +
               names_of(fit::board_texts()) + ", or a file that describes yours (default: a Pico)")
        ->type_name("NAME")
        ->group(option_group::board);
    app.footer(app.get_footer() + "\n\n" + key_list());
    app.callback([options] { preview(*options); });
}

}

const Command preview_command{"preview",
                              "Play a scene in a window, in the terminal, or unseen",
                              "kfast preview eyes.kfast --size 128x64 --format mono1\n"
                              "  kfast preview eyes.kfast --headless --press \"n n p right\"",
                              declare_preview,
                              {},
                              seeing_group};

}
