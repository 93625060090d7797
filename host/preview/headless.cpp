#include "host/preview/headless.hpp"

#include "core/bytes/crc32.hpp"
#include "host/preview/painter/raster_painter.hpp"
#include "host/preview/window/preview_screen.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/text/suggestion.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <thread>

namespace kfast {

namespace {

struct Named {
    std::string_view name;
    ScriptStep::Kind kind;
    bool is_number;
};

constexpr std::array step_names{
    Named{"frame=", ScriptStep::Kind::frame, true},
    Named{"select=", ScriptStep::Kind::select, false},
    Named{"open=", ScriptStep::Kind::open, false},
    Named{"wait=", ScriptStep::Kind::wait, true},
};

constexpr double largest_number = 1e6;

std::optional<double> read_number(std::string_view text)
{
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
    const bool is_number = error == std::errc{} && rest == end;
    return is_number && number >= 0 && number <= largest_number ? std::optional{number} : std::nullopt;
}

}

std::optional<ScriptStep> script_step(std::string_view word)
{
    if (const auto key = preview_key(word))
        return ScriptStep{.key = *key};
    const auto* const found =
        std::ranges::find_if(step_names, [word](const Named& row) { return word.starts_with(row.name); });
    if (found == step_names.end())
        return std::nullopt;
    const std::string_view value = word.substr(found->name.size());
    if (!found->is_number)
        return ScriptStep{.kind = found->kind, .text = std::string{value}};
    const auto number = read_number(value);
    return number ? std::optional{ScriptStep{.kind = found->kind, .number = *number}} : std::nullopt;
}

namespace {

using Seconds = PreviewPlayback::Seconds;

std::string hexadecimal(std::uint32_t value)
{
    std::ostringstream text;
    text << std::hex << std::setw(8) << std::setfill('0') << value;
    return text.str();
}

/// Counts and hashes what was shown.
class Summary {
public:
    void add(const Frame& frame)
    {
        crc_.add(frame.pixels);
        ++count_;
    }

    void write(std::ostream& out) const
    {
        out << counted(count_, "frame") << ", hash " << hexadecimal(crc_.value()) << '\n';
    }

private:
    Crc32 crc_;
    std::size_t count_ = 0;
};

Seconds clock_at(const Timeline& timeline, int frame)
{
    return Seconds{timeline.seconds(std::int64_t{frame} * Time::ticks_per_frame)};
}

PreviewPlayback::OnEvent writing_to(std::ostream& out)
{
    return [&out](const EventView& event) {
        out << "event " << in_frames(event.time) << ' ' << visible(event.name) << '\n';
    };
}

void select(Viewer& viewer, const std::string& name)
{
    const TimeTable& table = viewer.time_table();
    if (const TimeRow* const row = table.row_named(name))
        return viewer.select(row->item);
    viewer.select(std::nullopt);
    if (name.empty())
        return;
    std::vector<std::string_view> known_names;
    for (const TimeRow& known : table.rows)
        known_names.emplace_back(known.name);
    throw Failure("select=" + name + ": there is no such object: " + suggestion(name, known_names));
}

void take(const ScriptStep& step, Viewer& viewer, Seconds now, const KeyPress& press)
{
    switch (step.kind) {
    case ScriptStep::Kind::key:
        return press ? press(step.key, now) : viewer.press(step.key, now);
    case ScriptStep::Kind::frame:
        return viewer.scrub({static_cast<std::int32_t>(std::lround(step.number * Time::ticks_per_frame))});
    case ScriptStep::Kind::select:
        return select(viewer, step.text);
    case ScriptStep::Kind::open:
        return viewer.open(step.text, now);
    case ScriptStep::Kind::wait:
        viewer.attend(now);
        return;
    }
}

void write_messages(const Viewer& viewer, std::ostream& out)
{
    for (const std::string& line : viewer.errors())
        out << "error: " << line << '\n';
    if (!viewer.notice().empty())
        out << "notice: " << viewer.notice() << '\n';
}

}

void play_headless(FrameSource& source, const PlaybackSetup& playback_setup, std::ostream& out)
{
    const Timeline timeline{playback_setup.frame_rate, playback_setup.parts[playback_setup.first].stretch,
                            playback_setup.speed};
    PreviewPlayback playback{playback_setup, source.pace(), Seconds{0}, 1};
    playback.set_on_event(writing_to(out));
    Summary summary;
    for (int frame = 0; frame < timeline.frame_count(); ++frame) {
        playback.advance_to(clock_at(timeline, frame));
        summary.add(show(source, playback));
    }
    playback.advance_to(clock_at(timeline, timeline.frame_count())); // what is after the last frame
    summary.write(out);
}

void play_script(Viewer& viewer, std::span<const ScriptStep> script, std::ostream& out, const KeyPress& press)
{
    const double seconds_per_frame = clock_at(viewer.playback().timeline(), 1).count();
    viewer.set_on_event(writing_to(out));
    Summary summary;
    Seconds clock{0};
    for (const ScriptStep& step : script) {
        clock += Seconds{step.kind == ScriptStep::Kind::wait ? step.number : seconds_per_frame};
        take(step, viewer, clock, press);
        while (viewer.is_working())
            viewer.attend(clock);
        if (viewer.wants_to_quit())
            break;
        const Frame& frame = viewer.frame();
        summary.add(frame);
        write_messages(viewer, out);
        out << viewer.status() << "  " << hexadecimal(hash(frame)) << '\n';
    }
    viewer.set_on_event({});
    summary.write(out);
}

namespace {

void wait_for_report(Viewer& viewer)
{
    using namespace std::chrono_literals;
    while (viewer.view().fit_report && !viewer.fit_report())
        std::this_thread::sleep_for(10ms);
}

}

Picture snapshot(Viewer& viewer, std::span<const ScriptStep> script, Size window, std::ostream& out)
{
    RasterPainter painter;
    PreviewScreen screen;
    const auto draw = [&] {
        painter.begin(window);
        screen.draw(painter, viewer, Viewer::Seconds{0});
    };
    draw();
    play_script(viewer, script, out,
                [&](PreviewKey key, Viewer::Seconds now) { screen.press(key, viewer, now); });
    wait_for_report(viewer);
    draw();
    return painter.drawn();
}

}
