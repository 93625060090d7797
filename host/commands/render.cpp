#include "host/commands/command.hpp"
#include "host/commands/import_options.hpp"
#include "host/commands/output_folder.hpp"
#include "host/commands/output_path.hpp"
#include "host/commands/picture_options.hpp"
#include "host/commands/play_options.hpp"
#include "host/commands/time_text.hpp"
#include "host/failure.hpp"
#include "host/picture/gif.hpp"
#include "host/picture/png.hpp"
#include "host/scene_file.hpp"

#include <cstdio>
#include <iostream>

namespace kfast {
namespace {

namespace fs = std::filesystem;

struct RenderOptions {
    std::string file;
    std::string output;
    std::optional<int> frame;
    std::string time;
    bool all = false;
    PlayOptions play;
    PictureOptions picture;
};

Time frame_time(int frame, const Timeline& timeline)
{
    const int last = timeline.frame_count() - 1;
    if (frame < 0 || frame > last)
        throw CLI::ValidationError("--frame", std::to_string(frame) +
                                                  " is not played: there are frames 0 to " +
                                                  std::to_string(last));
    return timeline.frame_time(frame);
}

Time chosen_time(const RenderOptions& options, const Timeline& timeline)
{
    if (options.frame)
        return frame_time(*options.frame, timeline);
    const std::optional<Time> time = read_time(options.time, timeline.frame_rate);
    if (!time)
        throw CLI::ValidationError("--time", "'" + options.time +
                                                 "' is no time: write it like 1.5s, 500ms or 12.5 (frames)");
    return timeline.shown_at(time->ticks);
}

fs::path numbered(const fs::path& folder, int frame)
{
    char name[32];
    std::snprintf(name, sizeof name, "%04d.png", frame);
    return folder / name;
}

void render_folder(const fs::path& folder, FrameSource& source, const Timeline& timeline)
{
    make_output_folder(folder);
    for (int frame = 0; frame < timeline.frame_count(); ++frame)
        write_png(numbered(folder, frame), widen(source.show(timeline.frame_time(frame))));
}

/// A picture under the name of another kind, or a folder under that of a picture, is a slip.
void require_fitting_name(const RenderOptions& options)
{
    const fs::path kind = fs::path{options.output}.extension();
    if (options.all && kind == ".png")
        throw CLI::ValidationError("--output", "--all makes a folder or a .gif, not one .png");
    if (!options.all && kind == ".gif")
        throw CLI::ValidationError("--output", "one frame makes a .png: add --all for a .gif");
}

void render_scene(const RenderOptions& options)
{
    require_fitting_name(options);
    const SceneFile scene = load_scene(options.file);
    const Timeline timeline = chosen_timeline(options.play, scene.view);
    const auto source = open_source(options.picture, scene);
    const fs::path output = output_path(options.output, options.file);
    if (!options.all)
        write_png(output, widen(source->show(chosen_time(options, timeline))));
    else if (output.extension() == ".gif")
        write_gif(output, *source, timeline);
    else
        render_folder(output, *source, timeline);
}

void declare(CLI::App& app)
{
    const auto options = std::make_shared<RenderOptions>();
    app.add_option("FILE", options->file, loaded_scene)->required();
    app.add_option("-o,--output", options->output,
                   "A PNG; with --all a folder for 0000.png, 0001.png ... or a .gif")
        ->required();
    CLI::Option_group* moment = app.add_option_group("What to draw (one of these)");
    moment->add_option("--frame", options->frame, "The frame with this number, from 0")->type_name("N");
    moment
        ->add_option("--time", options->time,
                     "What is shown that long after the start: 1.5s, 500ms or 12.5 (frames)")
        ->type_name("T");
    moment->add_flag("--all", options->all, "Every frame; a GIF goes there and back for ping-pong");
    moment->require_option(1);
    declare_play_options(app, options->play);
    declare_seen_options(app, options->picture);
    app.callback([options] { render_scene(*options); });
}

}

const Command render_command{"render", "Draw a frame as a PNG, or all of them as PNGs or an animated GIF",
                             "kfast render eyes.kfast --time 1.5s -o eyes.png\n"
                             "  kfast render eyes.kfast --all -o eyes.gif\n"
                             "  kfast render eyes.kfast --clip blink --speed 0.5 --all -o blink.gif",
                             declare};

}
