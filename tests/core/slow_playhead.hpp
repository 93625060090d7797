#pragma once

#include "core/playhead.hpp"

#include <cstdlib>
#include <string>
#include <vector>

namespace kfast::test {

/// What a playhead must do, in steps of a quarter of a tick.
class SlowPlayhead {
public:
    SlowPlayhead(const PlayRange& stretch, const std::vector<EventView>& events)
        : stretch_{stretch}, events_{events}, quarter_{4 * stretch.begin.ticks}
    {
    }

    void seek(Time moment)
    {
        quarter_ = 4 * moment.ticks;
        there_ = false;
        returning_ = false;
    }

    /// `quarters` of the authored speed.
    std::string passed(int ticks, int quarters)
    {
        names_.clear();
        quarters_ = quarters;
        if (!there_)
            arrive();
        there_ = true;
        for (int i = 0; i < ticks * std::abs(quarters); ++i)
            step();
        return names_;
    }

    Time moment() const { return {quarter_ / 4}; }

private:
    int begin() const { return 4 * stretch_.begin.ticks; }
    int end() const { return 4 * stretch_.end.ticks; }
    bool runs_back() const { return (quarters_ < 0) != returning_; }

    void step()
    {
        const bool at_border = quarter_ == (runs_back() ? begin() : end());
        if (at_border && stretch_.loop == Loop::once)
            return;
        if (at_border && stretch_.loop == Loop::ping_pong)
            returning_ = !returning_;
        else if (at_border)
            jump(end());
        quarter_ += runs_back() ? -1 : 1;
        arrive();
        if (stretch_.loop == Loop::repeat && quarter_ == end())
            jump(begin());
    }

    void jump(int quarter)
    {
        quarter_ = quarter;
        arrive();
    }

    void arrive()
    {
        std::string here;
        for (const EventView& event : events_)
            if (4 * event.time.ticks == quarter_)
                here.append(event.name);
        names_ += runs_back() ? std::string{here.rbegin(), here.rend()} : here;
    }

    PlayRange stretch_;
    std::vector<EventView> events_;
    int quarter_;
    int quarters_ = 0;
    bool returning_ = false;
    bool there_ = false;
    std::string names_;
};

}
