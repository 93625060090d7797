#include "host/commands/render/rendering.hpp"

#include "host/commands/options/output_options.hpp"
#include "host/commands/render/contact_prints.hpp"
#include "host/commands/text/quantity_text.hpp"
#include "host/picture/apng.hpp"
#include "host/picture/film.hpp"
#include "host/picture/frame_source.hpp"
#include "host/picture/gif.hpp"
#include "host/picture/picture.hpp"
#include "host/picture/png.hpp"
#include "host/picture/sprite_sheet.hpp"
#include "host/picture/svg.hpp"
#include "host/picture/video.hpp"
#include "host/text/number_text.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <string_view>

namespace kfast {

namespace {

namespace fs = std::filesystem;

struct NamedKind {
    std::string_view ending;
    RenderKind of_moment; ///< folder if there is none
    RenderKind of_film;
};

constexpr std::array kinds{
    NamedKind{".png", RenderKind::png, RenderKind::apng},
    NamedKind{".svg", RenderKind::svg, RenderKind::svg},
    NamedKind{".apng", RenderKind::folder, RenderKind::apng},
    NamedKind{".gif", RenderKind::folder, RenderKind::gif},
    NamedKind{".mp4", RenderKind::folder, RenderKind::mp4},
    NamedKind{".webm", RenderKind::folder, RenderKind::webm},
};

[[noreturn]] void refuse(const std::string& reason) { throw CLI::ValidationError("--output", reason); }

[[noreturn]] void refuse_ending(const std::string& ending)
{
    std::string known;
    for (const NamedKind& kind : kinds)
        known.append(known.empty() ? "" : ", ").append(kind.ending);
    refuse("'" + ending + "' is no kind that there is: choose " + known +
           ", or with --all a name without an ending, or with / behind it, for a folder");
}

std::string lower(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

RenderKind kind_of_moment(const NamedKind& kind)
{
    if (kind.of_moment == RenderKind::folder)
        refuse("one frame makes a .png or an .svg: add --all for a " + std::string{kind.ending});
    return kind.of_moment;
}

void require_png(const std::string& ending, const char* what)
{
    if (ending != ".png")
        refuse(std::string{what} + " is a .png: choose such a name");
}

const NamedKind* kind_named(const std::string& ending)
{
    const auto kind = std::ranges::find(kinds, ending, &NamedKind::ending);
    return kind == kinds.end() ? nullptr : &*kind;
}

}

RenderSubject default_subject(const fs::path& output)
{
    const NamedKind* const kind = kind_named(lower(output.extension().string()));
    return kind != nullptr && kind->of_moment == RenderKind::folder ? RenderSubject::film
                                                                    : RenderSubject::moment;
}

RenderKind render_kind(const fs::path& output, RenderSubject subject)
{
    std::error_code unknown;
    const std::string ending = lower(output.extension().string());
    if (subject == RenderSubject::sprite_sheet || subject == RenderSubject::contact_sheet) {
        require_png(ending, subject == RenderSubject::sprite_sheet ? "a sheet" : "a contact sheet");
        return RenderKind::png;
    }
    const bool is_film = subject == RenderSubject::film;
    if (ending.empty() || (is_film && fs::is_directory(output, unknown)))
        return is_film ? RenderKind::folder : RenderKind::png;
    const NamedKind* const kind = kind_named(ending);
    if (kind == nullptr)
        refuse_ending(ending);
    return is_film ? kind->of_film : kind_of_moment(*kind);
}

namespace {

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

/// write(file, moment, sync) makes one of them.
template <class Write>
Rendered render_folder(const Rendering& job, const char* ending, Write write)
{
    make_output_folder(job.output);
    const int count = job.timeline.frame_count();
    std::uintmax_t bytes = 0;
    for (int frame = 0; frame < count; ++frame) {
        job.on_progress(static_cast<std::size_t>(frame), static_cast<std::size_t>(count));
        const fs::path file = job.output / (frame_digits(frame) + ending);
        write(file, job.timeline.frame_time(frame), Sync::later);
        bytes += written_bytes(file);
    }
    synchronize(job.output);
    return {counted(static_cast<std::size_t>(count), "file"), drawn_size(job), bytes};
}

template <class Write>
Rendered render_moment(const Rendering& job, Write write)
{
    write(job.output, chosen_time(job.options, job.timeline), Sync::now);
    return rendered(job, 1);
}

Rendered render_vectors(const Rendering& job, RenderKind kind)
{
    SvgSource source = svg_source_of(job);
    apply_inputs(job.options.picture, job.scene, source);
    const auto write = [&source](const fs::path& file, Time moment, Sync sync) {
        write_svg(file, source, moment, sync);
    };
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
    const auto write = [&source](const fs::path& file, Time moment, Sync sync) {
        write_png(file, widen(source.show(moment)), sync);
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

/// The sheet is enlarged with its labels.
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
