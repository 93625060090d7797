#include "host/beam/beam_source.hpp"
#include "host/commands/command.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/options/beam_options.hpp"
#include "host/commands/options/play_options.hpp"
#include "host/commands/render/picture_options.hpp"
#include "host/commands/text/progress.hpp"
#include "host/compile/scene_file.hpp"

#include <cstdio>
#include <iostream>
#include <unistd.h>

namespace kfast {
namespace {

struct HashOptions {
    std::string file;
    PlayOptions play;
    PictureOptions picture;
    std::optional<BeamProfile> beam;
};

std::string line(int frame, std::uint32_t hash)
{
    char text[32];
    std::snprintf(text, sizeof text, "%d %08x\n", frame, hash);
    return text;
}

/// `source` shows what hash() takes.
template <class Source>
void print_hashes(Source& source, const Timeline& timeline)
{
    WorkBar bar{"drawing"};
    const bool is_seen = ::isatty(STDOUT_FILENO) == 1; // the lines themselves show the progress
    const int count = timeline.frame_count();
    for (int frame = 0; frame < count; ++frame) {
        if (!is_seen)
            bar.report(static_cast<std::size_t>(frame), static_cast<std::size_t>(count));
        std::cout << line(frame, hash(source.show(timeline.frame_time(frame))));
    }
}

void print_hashes(const HashOptions& options)
{
    const SceneFile scene = load_scene(options.file);
    const Timeline timeline = chosen_timeline(options.play, scene.view);
    if (!options.beam)
        return print_hashes(*open_source(options.picture, scene), timeline);
    BeamSource points{scene.view, *options.beam};
    apply_inputs(options.picture, scene, points);
    print_hashes(points, timeline);
}

void declare_hash(CLI::App& app)
{
    const auto options = std::make_shared<HashOptions>();
    reads_scene(app.add_option("FILE", options->file, loaded_scene))->required();
    declare_play_options(app, options->play);
    declare_picture_options(app, options->picture);
    CLI::Option* beam = declare_beam_option(app, options->beam);
    for (const char* const other : {"--size", "--panel", "--scaling", "--format"})
        beam->excludes(app.get_option(other));
    app.callback([options] { print_hashes(*options); });
}

}

const Command hash_command{"hash",
                           "Print the CRC-32 of every frame, the same on every target",
                           "kfast hash eyes.kfb --size 128x64 --format mono1\n"
                           "  kfast hash eyes.kfb --beam scope",
                           declare_hash,
                           {},
                           seeing_group};

}
