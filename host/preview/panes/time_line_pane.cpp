#include "host/preview/panes/time_line_pane.hpp"

#include "host/preview/painter/painter.hpp"
#include "host/preview/painter/text_columns.hpp"
#include "host/preview/panes/theme.hpp"
#include "host/text/characters.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace kfast {
namespace {

constexpr Size letter = Painter::letter;
constexpr int name_margin = TimeLine::name_margin;
constexpr double key_radius = 5;

/// The text in the middle of a line that is `height` pixels high.
int text_y(int y, int height) { return y + (height - letter.height) / 2; }

void draw_text(Painter& painter, int x, int y, int right, std::string_view text, Colour colour)
{
    painter.text(x, y, cut(text, (right - x) / letter.width), colour);
}

void draw_centred(Painter& painter, double x, int y, const std::string& text, Colour colour)
{
    painter.text(static_cast<int>(std::lround(x - columns_of(text) * letter.width / 2.0)), y, text, colour);
}

std::string seconds_text(double seconds)
{
    char text[24];
    std::snprintf(text, sizeof text, "%g s", std::round(seconds * 1000) / 1000);
    return text;
}

class TimeLineDrawing {
public:
    TimeLineDrawing(Painter& painter, const TimeLine& line, const TimeLineState& state)
        : painter_{painter}, line_{line}, table_{line.table()}, state_{state}
    {
    }

    void draw()
    {
        painter_.fill(line_.pane(), theme::surface);
        draw_rows();
        draw_names();
        draw_scroll_bar();
        draw_moments();
        painter_.fill({line_.pane().x, line_.pane().y, line_.pane().width, 1}, theme::border);
    }

private:
    void draw_rows()
    {
        for (std::size_t row = line_.first_row(); row < line_.end_row(); ++row) {
            if (is_selected(row))
                painter_.fill(line_.row(row), theme::selected);
            else if (row % 2 == 0)
                painter_.fill(line_.row(row), theme::lane);
        }
    }

    bool is_selected(std::size_t row) const { return state_.selected == table_.rows[row].item; }

    double radius_of_keys(std::size_t row) const
    {
        return table_.rows[row].is_quantity ? key_radius - 1 : key_radius;
    }

    void draw_names()
    {
        const Rect ruler = line_.ruler();
        draw_lane_name(ruler.y + 1, "frame");
        draw_lane_name(ruler.y + letter.height, "second");
        draw_lane_name(line_.clips(), "clips");
        draw_lane_name(line_.events(), "events");
        for (std::size_t row = line_.first_row(); row < line_.end_row(); ++row) {
            const TimeRow& item = table_.rows[row];
            const Rect triangle = line_.triangle(row);
            const int y = text_y(triangle.y, triangle.height);
            if (item.can_unfold() && right_of(triangle) <= line_.moments().x)
                painter_.text(triangle.x, y, item.is_unfolded ? "▾" : "▸", theme::quiet_text);
            draw_text(painter_, right_of(triangle), y, line_.moments().x, visible(item.name),
                      is_selected(row) && !item.is_quantity ? theme::text : theme::quiet_text);
        }
    }

    void draw_lane_name(int y, const char* name)
    {
        draw_text(painter_, line_.pane().x + name_margin, y, line_.moments().x, name, theme::heading);
    }

    void draw_lane_name(const Rect& lane, const char* name)
    {
        if (lane.height == TimeLine::lane_height)
            draw_lane_name(text_y(lane.y, lane.height), name);
    }

    void draw_scroll_bar()
    {
        constexpr int width = 4;
        const Rect rows = line_.rows();
        if (line_.last_first_row() == 0 || is_empty(rows))
            return;
        const auto y_of = [&](std::size_t row) {
            return rows.y +
                   static_cast<int>(row * static_cast<std::size_t>(rows.height) / table_.rows.size());
        };
        const int top = y_of(line_.first_row());
        painter_.fill({right_of(rows) - width, top, width, std::max(6, y_of(line_.end_row()) - top)},
                      theme::quiet_text);
    }

    void draw_moments()
    {
        const Clipped within{painter_, line_.moments()};
        draw_frame_numbers();
        draw_seconds();
        draw_clips();
        draw_events();
        for (std::size_t row = line_.first_row(); row < line_.end_row(); ++row)
            draw_keys(row);
        draw_play_head();
    }

    double frames() const { return in_frames(table_.end); }

    double pixels_per_frame() const { return line_.x_of(Time::frame(1)) - line_.x_of(Time::frame(0)); }

    void draw_frame_numbers()
    {
        const int digits = static_cast<int>(std::to_string(static_cast<int>(frames())).size());
        const int step = ruler_step(pixels_per_frame(), (digits + 3) * letter.width);
        const int small_step = ruler_step(pixels_per_frame(), 5);
        const Rect ruler = line_.ruler();
        for (int frame = 0; frame <= static_cast<int>(frames()); frame += small_step) {
            const double x = line_.x_of(Time::frame(frame));
            const int height = frame % step == 0 ? 6 : 3;
            painter_.fill({static_cast<int>(x), bottom_of(ruler) - height, 1, height}, theme::track);
            if (frame % step == 0)
                draw_centred(painter_, x, ruler.y + 1, std::to_string(frame), theme::text);
        }
    }

    /// Seconds between two numbers of the ruler.
    double seconds_step(double pixels) const
    {
        for (double step = 0.001;; step *= 10)
            for (const double times : std::array{1.0, 2.0, 5.0})
                if (step * times * pixels >= 9 * letter.width)
                    return step * times;
    }

    void draw_seconds()
    {
        const double rate = state_.frame_rate / 1000.0;
        const double pixels = pixels_per_frame() * rate;
        if (pixels <= 0)
            return;
        const double step = seconds_step(pixels);
        const double origin = line_.x_of(Time{0});
        for (int i = 0; i * step * rate <= frames() + 1e-9; ++i)
            draw_centred(painter_, origin + i * step * pixels, line_.ruler().y + letter.height - 2,
                         seconds_text(i * step), theme::quiet_text);
    }

    void draw_clips()
    {
        const Rect lane = line_.clips();
        if (lane.height < TimeLine::lane_height)
            return;
        for (const Part& clip : table_.clips) {
            const int left = static_cast<int>(line_.x_of(clip.stretch.begin));
            const int right = static_cast<int>(line_.x_of(clip.stretch.end));
            const Rect bar{left, lane.y + 2, std::max(3, right - left - 1), lane.height - 4};
            painter_.fill({bar.x - 1, bar.y, 1, bar.height}, theme::surface); // where clips overlap
            draw_round_rect(painter_, bar, std::min(3.0, bar.width / 2.0),
                            clip.name == state_.clip ? theme::playing_clip : theme::clip);
            draw_text(painter_, left + 5, text_y(lane.y, lane.height), right - 4, visible(clip.name),
                      theme::text);
        }
    }

    void draw_events()
    {
        const Rect lane = line_.events();
        if (lane.height < TimeLine::lane_height)
            return;
        for (std::size_t i = 0; i < table_.events.size(); ++i) {
            const double x = line_.x_of(table_.events[i].time);
            const double next =
                i + 1 < table_.events.size() ? line_.x_of(table_.events[i + 1].time) : right_of(lane);
            painter_.fill({static_cast<int>(x), lane.y + 3, 1, lane.height - 4}, theme::event);
            painter_.polygon(std::array{WindowSpot{x, lane.y + 3.0}, WindowSpot{x + 8, lane.y + 6.5},
                                        WindowSpot{x, lane.y + 10.0}},
                             theme::event);
            draw_text(painter_, static_cast<int>(x) + 11, text_y(lane.y, lane.height),
                      static_cast<int>(next) - 4, visible(table_.events[i].name), theme::event);
        }
    }

    void draw_keys(std::size_t number)
    {
        const Rect row = line_.row(number);
        const double y = row.y + row.height / 2.0;
        const std::vector<Time>& keys = table_.rows[number].keys;
        if (keys.size() > 1)
            draw_line(painter_, {line_.x_of(keys.front()), y}, {line_.x_of(keys.back()), y}, 1,
                      theme::faint(theme::key, 90));
        for (const Time key : keys) {
            const WindowSpot at{line_.x_of(key), y};
            draw_diamond(painter_, at, radius_of_keys(number) + 1.5, theme::surface);
            draw_diamond(painter_, at, radius_of_keys(number),
                         key == state_.now ? theme::play_head : theme::key);
        }
    }

    void draw_play_head()
    {
        const double x = line_.x_of(state_.now);
        const Rect ruler = line_.ruler();
        const double top = bottom_of(ruler) - 8.0;
        draw_line(painter_, {x, top}, {x, static_cast<double>(bottom_of(line_.pane()))}, 1.5,
                  theme::play_head);
        painter_.polygon(std::array{WindowSpot{x - 6, top}, WindowSpot{x + 6, top}, WindowSpot{x, top + 8}},
                         theme::play_head);
    }

    Painter& painter_;
    const TimeLine& line_;
    const TimeTable& table_;
    const TimeLineState& state_;
};

}

int ruler_step(double pixels_per_frame, double room)
{
    for (int step = 1; step < 1'000'000; step *= 10)
        for (const int times : {1, 2, 5})
            if (step * times * pixels_per_frame >= room)
                return step * times;
    return 1'000'000;
}

void draw_time_line(Painter& painter, const TimeLine& line, const TimeLineState& state)
{
    if (!is_empty(line.pane()))
        TimeLineDrawing{painter, line, state}.draw();
}

}
