#include "host/commands/render/rendering.hpp"

#include "host/commands/options/output_folder.hpp"
#include "host/commands/options/output_path.hpp"
#include "host/commands/options/report_options.hpp"
#include "host/commands/render/contact_prints.hpp"
#include "host/commands/text/time_text.hpp"
#include "host/picture/apng.hpp"
#include "host/picture/film_moment.hpp"
#include "host/picture/gif.hpp"
#include "host/picture/gif_moment.hpp"
#include "host/picture/picture_part.hpp"
#include "host/picture/png.hpp"
#include "host/picture/scaled_source.hpp"
#include "host/picture/sprite_sheet.hpp"
#include "host/picture/svg.hpp"
#include "host/picture/video.hpp"
#include "host/text/counted.hpp"

#include <iostream>
#include <memory>

namespace kfast {
namespace {

namespace fs = std::filesystem;

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

Size drawn_size(const Rendering& job)
{
    const Size size = shown_size(job.options.picture, job.scene.view);
    return {size.width * job.options.scale, size.height * job.options.scale};
}

Rendered rendered(const Rendering& job, std::size_t frames)
{
    return {counted(frames, "frame"), drawn_size(job), written_bytes(job.output)};
}

std::size_t film_length(const Rendering& job) { return film_moments(job.timeline).size(); }

/// write(name without ending, moment) makes one file.
template <class Write>
Rendered render_folder(const Rendering& job, const char* ending, Write write)
{
    make_output_folder(job.output);
    const int count = job.timeline.frame_count();
    std::uintmax_t bytes = 0;
    for (int frame = 0; frame < count; ++frame) {
        job.on_progress(static_cast<std::size_t>(frame), static_cast<std::size_t>(count));
        const fs::path file = job.output / (frame_digits(frame) + ending);
        write(file, job.timeline.frame_time(frame));
        bytes += written_bytes(file);
    }
    return {counted(static_cast<std::size_t>(count), "file"), drawn_size(job), bytes};
}

template <class Write>
Rendered render_moment(const Rendering& job, Write write)
{
    write(job.output, chosen_time(job.options, job.timeline));
    return rendered(job, 1);
}

Rendered render_vectors(const Rendering& job, RenderKind kind)
{
    SvgSource source = svg_source_of(job);
    apply_inputs(job.options.picture, job.scene, source);
    const auto write = [&source](const fs::path& file, Time moment) { write_svg(file, source, moment); };
    if (kind == RenderKind::folder)
        return render_folder(job, ".svg", write);
    if (!job.options.all)
        return render_moment(job, write);
    write_animated_svg(job.output, source, job.timeline, job.on_progress);
    return rendered(job, film_length(job));
}

void report_padding(Size size)
{
    if (is_padded(size))
        std::cerr << "kfast: videos have sides of even length: the last column or row of " << size.width
                  << " x " << size.height << " pixels is there twice\n";
}

Rendered render_video(const Rendering& job, RenderKind kind, FrameSource& source)
{
    const int loops = job.options.loops.value_or(1);
    report_padding(drawn_size(job));
    const VideoKind video = kind == RenderKind::mp4 ? VideoKind::mp4 : VideoKind::webm;
    write_video(job.output, video, source, job.timeline, loops, job.on_progress);
    return rendered(job, film_length(job) * static_cast<std::size_t>(loops));
}

Rendered render_film(const Rendering& job, RenderKind kind, FrameSource& source)
{
    const auto write = [&source](const fs::path& file, Time moment) {
        write_png(file, widen(source.show(moment)));
    };
    switch (kind) {
    case RenderKind::folder:
        return render_folder(job, ".png", write);
    case RenderKind::apng:
        write_apng(job.output, source, job.timeline, job.on_progress);
        return rendered(job, film_length(job));
    case RenderKind::gif:
        write_gif(job.output, source, job.timeline, job.on_progress);
        return rendered(job, gif_moments(job.timeline).size());
    case RenderKind::mp4:
    case RenderKind::webm:
        return render_video(job, kind, source);
    case RenderKind::png:
    case RenderKind::svg:
        break;
    }
    return render_moment(job, write);
}

Rendered render_sprite_sheet(const Rendering& job, FrameSource& source)
{
    const fs::path list = output_path(sprite_list_path(job.output), job.options.file);
    const SpriteSheetForm form{*job.options.columns, job.options.has_way_back};
    const SpriteSheet sheet = write_sprite_sheet(job.output, source, job.timeline, form, job.on_progress);
    return {counted(sheet.pictures, "frame") + " and " + list.filename().string(), sheet.size,
            written_bytes(job.output)};
}

/// Enlarged with its labels.
Rendered render_contact_sheet(const Rendering& job)
{
    const PictureOptions& asked = job.options.picture;
    const auto moments = contact_moments(job.scene.view, job.timeline);
    const ContactPlan plan = contact_plan(moments, shown_size(asked, job.scene.view), job.options.scale);
    const PictureOptions chosen = plan.divisor == 1 ? asked : drawn_at(asked, plan.picture);
    const auto source = open_source(chosen, job.scene);
    const auto prints = contact_prints(moments, *source, job.on_progress);
    const Picture sheet = scaled(contact_sheet(prints, plan.layout), job.options.scale);
    write_png(job.output, sheet);
    return {counted(moments.size(), "key") +
                (plan.divisor == 1 ? "" : " at 1/" + std::to_string(plan.divisor) + " of their size"),
            sheet.size, written_bytes(job.output), source->min_detail()};
}

}

bool is_vector(const RenderOptions& options, RenderKind kind)
{
    return kind == RenderKind::svg || (kind == RenderKind::folder && options.kind == "svg");
}

Rendered render_subject(const Rendering& job, RenderSubject subject, RenderKind kind)
{
    if (subject == RenderSubject::contact_sheet)
        return render_contact_sheet(job);
    if (is_vector(job.options, kind))
        return render_vectors(job, kind);
    const auto source = source_of(job);
    Rendered done = subject == RenderSubject::sprite_sheet ? render_sprite_sheet(job, *source)
                                                           : render_film(job, kind, *source);
    done.min_detail = source->min_detail();
    return done;
}

}
