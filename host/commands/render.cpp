#include "host/commands/command.hpp"
#include "host/commands/contact_prints.hpp"
#include "host/commands/import_options.hpp"
#include "host/commands/number_range.hpp"
#include "host/commands/output_folder.hpp"
#include "host/commands/output_option.hpp"
#include "host/commands/output_path.hpp"
#include "host/commands/picture_options.hpp"
#include "host/commands/play_options.hpp"
#include "host/commands/render_kind.hpp"
#include "host/commands/time_text.hpp"
#include "host/commands/work_bar.hpp"
#include "host/failure.hpp"
#include "host/picture/apng.hpp"
#include "host/picture/gif.hpp"
#include "host/picture/picture_part.hpp"
#include "host/picture/png.hpp"
#include "host/picture/scaled_source.hpp"
#include "host/picture/sprite_sheet.hpp"
#include "host/picture/svg.hpp"
#include "host/picture/video.hpp"
#include "host/scene_file.hpp"

#include <cstdio>
#include <iostream>

namespace kfast {
namespace {

namespace fs = std::filesystem;

constexpr int most_loops = 1000;
constexpr int most_columns = 1000;
constexpr int largest_scale = 64;

struct RenderOptions {
    std::string file;
    std::string output;
    std::optional<int> frame;
    std::optional<std::string> time;
    bool all = false;
    bool contact = false;
    std::optional<int> columns; ///< of a sprite sheet
    bool has_way_back = false;  ///< likewise
    std::string kind;           ///< of the files in a folder
    int scale = 1;
    std::optional<int> loops;
    PlayOptions play;
    PictureOptions picture;
    bool is_format_told = false;
};

/// What is to be done, when all options are known to fit each other.
struct Rendering {
    const RenderOptions& options;
    const SceneFile& scene;
    Timeline timeline;
    fs::path output;
    TellWork tell;
};

RenderSubject subject_of(const RenderOptions& options, const fs::path& output)
{
    if (options.columns)
        return RenderSubject::sprite_sheet;
    if (options.contact)
        return RenderSubject::contact_sheet;
    if (options.all)
        return RenderSubject::film;
    return options.frame || options.time ? RenderSubject::moment : usual_subject(output);
}

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
    if (!options.time)
        return frame_time(options.frame.value_or(0), timeline);
    const std::optional<Time> time = read_time(*options.time, timeline.frame_rate);
    if (!time)
        throw CLI::ValidationError("--time", "'" + *options.time +
                                                 "' is no time: write it like 1.5s, 500ms or 12.5 (frames)");
    return timeline.shown_at(time->ticks);
}

bool is_vector(const RenderOptions& options, RenderKind kind)
{
    return kind == RenderKind::svg || (kind == RenderKind::folder && options.kind == "svg");
}

void require_vector_options(const RenderOptions& options)
{
    if (options.picture.screen.beam)
        throw CLI::ValidationError("--beam", "the light of a vector display has no outlines: make a .png or "
                                             "a .gif, or its points with 'kfast export'");
    if (options.is_format_told)
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

std::unique_ptr<FrameSource> source_of(const Rendering& job)
{
    auto source = open_source(job.options.picture, job.scene);
    if (job.options.scale == 1)
        return source;
    return std::make_unique<ScaledSource>(std::move(source), job.options.scale);
}

SvgSource svg_source_of(const Rendering& job)
{
    const PictureOptions& picture = job.options.picture;
    return {job.scene.view, panel_size(picture, job.scene.view), picture.fit};
}

fs::path numbered(const fs::path& folder, int frame, const char* ending)
{
    char name[32];
    std::snprintf(name, sizeof name, "%04d%s", frame, ending);
    return folder / name;
}

/// write(name without ending, moment) makes one file.
template <class Write>
void render_folder(const Rendering& job, const char* ending, Write write)
{
    make_output_folder(job.output);
    const int count = job.timeline.frame_count();
    for (int frame = 0; frame < count; ++frame) {
        job.tell(static_cast<std::size_t>(frame), static_cast<std::size_t>(count));
        write(numbered(job.output, frame, ending), job.timeline.frame_time(frame));
    }
}

void render_vectors(const Rendering& job, RenderKind kind)
{
    SvgSource source = svg_source_of(job);
    tell_inputs(job.options.picture, job.scene, source);
    const auto write = [&source](const fs::path& file, Time moment) { write_svg(file, source, moment); };
    if (kind == RenderKind::folder)
        return render_folder(job, ".svg", write);
    if (job.options.all)
        return write_animated_svg(job.output, source, job.timeline, job.tell);
    write(job.output, chosen_time(job.options, job.timeline));
}

void tell_padding(Size size)
{
    if (is_padded(size))
        std::cerr << "kfast: videos have sides of even length: the last column or row of " << size.width
                  << " x " << size.height << " pixels is there twice\n";
}

void render_video(const Rendering& job, RenderKind kind, FrameSource& source)
{
    tell_padding(source.show(job.timeline.shown_at(0)).size);
    const VideoKind video = kind == RenderKind::mp4 ? VideoKind::mp4 : VideoKind::webm;
    write_video(job.output, video, source, job.timeline, job.options.loops.value_or(1), job.tell);
}

void render_film(const Rendering& job, RenderKind kind)
{
    const auto source = source_of(job);
    const auto write = [&source](const fs::path& file, Time moment) {
        write_png(file, widen(source->show(moment)));
    };
    switch (kind) {
    case RenderKind::folder:
        return render_folder(job, ".png", write);
    case RenderKind::apng:
        return write_apng(job.output, *source, job.timeline, job.tell);
    case RenderKind::gif:
        return write_gif(job.output, *source, job.timeline, job.tell);
    case RenderKind::mp4:
    case RenderKind::webm:
        return render_video(job, kind, *source);
    case RenderKind::png:
    case RenderKind::svg:
        return write(job.output, chosen_time(job.options, job.timeline));
    }
}

void render_sprite_sheet(const Rendering& job)
{
    output_path(sprite_list_path(job.output), job.options.file);
    const SpriteSheetForm form{*job.options.columns, job.options.has_way_back};
    write_sprite_sheet(job.output, *source_of(job), job.timeline, form, job.tell);
}

/// Enlarged with its labels.
void render_contact_sheet(const Rendering& job)
{
    const auto source = open_source(job.options.picture, job.scene);
    const auto prints = contact_prints(job.scene.view, job.timeline, *source, job.tell);
    write_png(job.output, scaled(contact_sheet(prints), job.options.scale));
}

void render_scene(const RenderOptions& options)
{
    const fs::path output = output_path(options.output, options.file);
    const RenderSubject subject = subject_of(options, output);
    const RenderKind kind = render_kind(output, subject);
    require_fitting_options(options, kind);
    const SceneFile scene = load_scene(options.file);
    WorkBar bar{"drawing"};
    const Rendering job{options, scene, chosen_timeline(options.play, scene.view), output, bar.teller()};
    if (subject == RenderSubject::sprite_sheet)
        render_sprite_sheet(job);
    else if (subject == RenderSubject::contact_sheet)
        render_contact_sheet(job);
    else if (is_vector(options, kind))
        render_vectors(job, kind);
    else
        render_film(job, kind);
}

void declare_subject(CLI::App& app, RenderOptions& options)
{
    CLI::Option_group* subject = app.add_option_group(
        "What to draw (one of these; without: frame 0, or all of an animation or a video)");
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
        ->check(number_within(1, most_columns));
    subject->add_flag("--contact", options.contact,
                      "The key frames on one PNG, each with its number and its seconds");
    subject->require_option(0, 1);
}

void declare_files(CLI::App& app, RenderOptions& options)
{
    declare_output(app, options.output,
                   "A .png or .svg; with --all a folder, or .apng, .png, .gif, .svg, .mp4 or .webm")
        ->required();
    app.add_option("--kind", options.kind, "The files in a folder: png (default) or svg")
        ->type_name("KIND")
        ->check(CLI::IsMember({"png", "svg"}));
    app.add_option("--scale", options.scale, "Each pixel as a square of so many a side")
        ->type_name("N")
        ->check(number_within(1, largest_scale));
    app.add_flag("--way-back", options.has_way_back, "On a sheet, the way back of ping-pong, too");
    app.add_option("--loops", options.loops, "Play a video so many times (default: 1)")
        ->type_name("N")
        ->check(number_within(1, most_loops));
}

void declare_render(CLI::App& app)
{
    const auto options = std::make_shared<RenderOptions>();
    app.add_option("FILE", options->file, loaded_scene)->required();
    declare_files(app, *options);
    declare_subject(app, *options);
    declare_play_options(app, options->play);
    declare_seen_options(app, options->picture);
    const CLI::Option* const format = app.get_option("--format");
    app.callback([options, format] {
        options->is_format_told = format->count() > 0;
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
                             declare_render};

}
