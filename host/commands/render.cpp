#include "host/commands/command.hpp"
#include "host/commands/import/import_options.hpp"
#include "host/commands/options/option_facts.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/commands/options/output_options.hpp"
#include "host/commands/render/rendering.hpp"
#include "host/commands/text/progress.hpp"
#include "host/compile/scene_file.hpp"
#include "host/program/failure.hpp"

#include <iostream>

namespace kfast {
namespace {

namespace fs = std::filesystem;

constexpr int max_loops = 1000;
constexpr int max_columns = 1000;
constexpr int largest_scale = 64;

RenderSubject subject_of(const RenderOptions& options, const fs::path& output)
{
    if (options.columns)
        return RenderSubject::sprite_sheet;
    if (options.contact)
        return RenderSubject::contact_sheet;
    if (options.all)
        return RenderSubject::film;
    return options.frame || options.time ? RenderSubject::moment : default_subject(output);
}

void require_vector_options(const RenderOptions& options)
{
    if (options.picture.screen.beam)
        throw CLI::ValidationError("--beam", "the light of a vector display has no outlines: make a .png or "
                                             "a .gif, or its points with 'kfast export'");
    if (options.is_format_given)
        throw CLI::ValidationError("--format", "an SVG has no pixels: leave it out, or make a .png");
    if (options.scale != 1)
        throw CLI::ValidationError("--scale", "an SVG has no pixels: it is sharp in any size; choose --size "
                                              "for its own");
}

void require_fitting_options(const RenderOptions& options, RenderKind kind)
{
    if (is_vector(options, kind))
        require_vector_options(options);
    if (!options.kind.empty() && kind != RenderKind::folder)
        throw CLI::ValidationError("--kind", "it is for the files in a folder: name one with --all -o");
    if (options.has_way_back && !options.columns)
        throw CLI::ValidationError("--way-back", "it is for --sheet: animations and videos have it anyway");
    if (options.loops && !is_video(kind))
        throw CLI::ValidationError("--loops", "it is for videos, .mp4 and .webm: the other kinds repeat "
                                              "themselves as the scene does");
}

/// A board with a panel of the same size draws the same.
void print_lack_of_room(Detail detail)
{
    if (detail != Detail::full)
        std::cerr << "kfast: "
                  << (detail == Detail::coarse ? "curves are coarser" : "parts of the picture are missing")
                  << ", for outlines find no room, nor would they on a board: a smaller --size has it, or a "
                     "scene of fewer curves\n";
}

void render_scene(const RenderOptions& options)
{
    const fs::path output = output_path(options.output, options.file);
    const RenderSubject subject = subject_of(options, output);
    const RenderKind kind = render_kind(output, subject);
    require_fitting_options(options, kind);
    const SceneFile scene = load_scene(options.file);
    std::optional<WorkBar> bar{"drawing"};
    const Rendering job{options, scene, chosen_timeline(options.play, scene.view), output, bar->callback()};
    const Rendered done = render_subject(job, subject, kind);
    bar.reset();
    print_lack_of_room(done.min_detail);
    report_stream(options.quiet) << written_picture_text(output, done.contents, done.size, done.bytes)
                                 << '\n';
}

void declare_subject(CLI::App& app, RenderOptions& options)
{
    const OptionHeading heading{app, option_group::what_to_draw};
    CLI::Option_group* subject = app.add_option_group(option_group::what_to_draw);
    subject->add_option("--frame", options.frame, "The frame with this number, from 0")->type_name("N");
    subject
        ->add_option("--time", options.time,
                     "What is shown that long after the start: 1.5s, 500ms or 12.5 (frames)")
        ->type_name("T");
    subject->add_flag("--all", options.all, "Every frame; an animation goes there and back for ping-pong");
    subject
        ->add_option("--sheet", options.columns,
                     "Every frame on one PNG, so many in a row, and a .json that tells where they are")
        ->type_name("COLUMNS")
        ->check(number_within(1, max_columns));
    subject->add_flag("--contact", options.contact,
                      "The key frames on one PNG, each with its number and its seconds");
    subject->require_option(0, 1);
}

void declare_files(CLI::App& app, RenderOptions& options)
{
    declare_output(app, options.output,
                   "A .png or .svg; with --all a folder, or .apng, .png, .gif, .svg, .mp4 or .webm")
        ->required();
    const OptionHeading heading{app, option_group::output};
    app.add_option("--kind", options.kind, "The files in a folder: png (default) or svg")
        ->type_name("KIND")
        ->check(one_of({"png", "svg"}));
    app.add_option("--scale", options.scale, "Each pixel as a square of so many a side")
        ->type_name("N")
        ->check(number_within(1, largest_scale));
    app.add_flag("--way-back", options.has_way_back, "On a sheet, the way back of ping-pong, too");
    const OptionHeading playing{app, option_group::play};
    app.add_option("--loops", options.loops, "Play a video so many times (default: 1)")
        ->type_name("N")
        ->check(number_within(1, max_loops));
}

void declare_render(CLI::App& app)
{
    const auto options = std::make_shared<RenderOptions>();
    reads_scene(app.add_option("FILE", options->file, loaded_scene))->required();
    declare_files(app, *options);
    declare_subject(app, *options);
    declare_play_options(app, options->play);
    declare_seen_options(app, options->picture);
    declare_quiet(app, options->quiet);
    const CLI::Option* const format = app.get_option("--format");
    app.callback([options, format] {
        options->is_format_given = format->count() > 0;
        render_scene(*options);
    });
}

}

const Command render_command{"render",
                             "Draw a frame, or all of them, as pictures, animations, videos or sheets",
                             "kfast render eyes.kfast --time 1.5s -o eyes.png\n"
                             "  kfast render eyes.kfast --all --scale 3 -o eyes.apng\n"
                             "  kfast render eyes.kfast --all --loops 4 -o eyes.mp4\n"
                             "  kfast render eyes.kfast --clip blink --speed 0.5 --all -o blink.gif\n"
                             "  kfast render eyes.kfast --contact -o keys.png",
                             declare_render,
                             {},
                             seeing_group};

}
