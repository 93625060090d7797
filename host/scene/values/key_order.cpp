#include "host/scene/values/key_order.hpp"

#include <string>

namespace kfast::scene {

bool comes_later(std::string_view noun, PlacedMoment before, PlacedMoment at, const KeyDriver& driver,
                 SceneContext& context)
{
    if (before.time < at.time)
        return true;
    const std::string name{noun};
    const std::string moment{driver.noun()};
    const std::string line = context.report.line(before.place);
    if (at.time == before.time)
        return context.report.error(at.place,
                                    "there is a " + name + " at this " + moment + " already, on " + line,
                                    std::string{driver.grain()});
    return context.report.error(at.place,
                                "this " + name + " is " + (driver.is_time() ? "earlier" : "lower") +
                                    " than the one before it, on " + line,
                                "put the " + name + "s in the order of their " + moment + "s");
}

}
