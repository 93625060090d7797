#include "host/picture/svg.hpp"

#include "host/file/atomic_file.hpp"
#include "host/picture/film.hpp"
#include "host/picture/svg_attributes.hpp"

#include <cstdio>
#include <string>

namespace kfast {
namespace {

std::string head(const SvgSource& source)
{
    const std::string width = std::to_string(source.size().width);
    const std::string height = std::to_string(source.size().height);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + ' ' + height + "\">\n<rect width=\"" + width + "\" height=\"" +
           height + '"' + paint_text("fill", source.background(), 255) + "/>\n";
}

constexpr const char* tail = "</svg>\n";

void write_text(const std::filesystem::path& target, const std::string& text, Sync sync)
{
    write_file(target, std::as_bytes(std::span{text}), sync);
}

struct SvgFrame {
    std::string elements;
    std::int64_t begin;
    std::int64_t end;
};

std::vector<SvgFrame> frames_of(SvgSource& source, const Timeline& timeline,
                                const ProgressCallback& on_progress, const FilmLimit& limit)
{
    const std::vector<FilmMoment> moments = film_moments(timeline);
    std::vector<SvgFrame> frames;
    std::size_t bytes = 0;
    for (std::size_t done = 0; done < moments.size(); ++done) {
        on_progress(done, moments.size());
        std::string elements = source.show(moments[done].time);
        if (!frames.empty() && frames.back().elements == elements) {
            frames.back().end = moments[done].end;
            continue;
        }
        limit.require(bytes += elements.size(), "SVG");
        frames.push_back({std::move(elements), moments[done].begin, moments[done].end});
    }
    return frames;
}

std::string decimal(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", number);
    return text;
}

/// Writes frames that alternate.
class Turns {
public:
    Turns(const Timeline& timeline, std::int64_t end)
        : end_{end},
          rest_{" dur=\"" + decimal(timeline.seconds(end)) + "s\" calcMode=\"discrete\"" +
                (timeline.stretch.loop == Loop::once ? " fill=\"freeze\"/>\n"
                                                     : " repeatCount=\"indefinite\"/>\n")}
    {
    }

    /// The first one is also shown where nothing moves.
    std::string group(const SvgFrame& frame) const
    {
        return std::string{frame.begin == 0 ? "<g>\n" : "<g display=\"none\">\n"} + animation(frame) +
               frame.elements + "</g>\n";
    }

private:
    std::string animation(const SvgFrame& frame) const
    {
        std::string values = frame.begin == 0 ? "inline" : "none;inline";
        std::string times = frame.begin == 0 ? "0" : "0;" + share(frame.begin);
        if (frame.end < end_) {
            values += ";none";
            times += ';' + share(frame.end);
        }
        return "<animate attributeName=\"display\" values=\"" + values + "\" keyTimes=\"" + times + '"' +
               rest_;
    }

    std::string share(std::int64_t ticks) const
    {
        return decimal(static_cast<double>(ticks) / static_cast<double>(end_));
    }

    std::int64_t end_;
    std::string rest_;
};

}

void write_svg(const std::filesystem::path& target, SvgSource& source, Time moment, Sync sync)
{
    write_text(target, head(source) + source.show(moment) + tail, sync);
}

void write_animated_svg(const std::filesystem::path& target, SvgSource& source, const Timeline& timeline,
                        const ProgressCallback& on_progress, const FilmLimit& limit)
{
    const std::vector<SvgFrame> frames = frames_of(source, timeline, on_progress, limit);
    const Turns turns{timeline, frames.back().end};
    std::string text = head(source);
    for (const SvgFrame& frame : frames)
        text += frames.size() == 1 ? frame.elements : turns.group(frame);
    write_text(target, text + tail, Sync::now);
}

}
