#include "host/scene/key_order.hpp"

#include <string>

namespace kfast::scene {

bool comes_later(std::string_view noun, Moment before, Moment at, Reading& reading)
{
    if (before.time < at.time)
        return true;
    const std::string name{noun};
    const std::string line = reading.report.line(before.place);
    if (at.time == before.time)
        return reading.report.error(at.place, "there is a " + name + " at this time already, on " + line,
                                    "times are rounded to 1/1024 frame; choose another");
    return reading.report.error(at.place, "this " + name + " is earlier than the one before it, on " + line,
                                "put the " + name + "s in the order of their times");
}

}
