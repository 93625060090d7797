#pragma once

#include "core/time/time.hpp"
#include "host/scene/reading.hpp"
#include "host/scene/value_reader.hpp"

#include <string>

namespace kfast::scene {

/// `what` is "this clip ends", say; `length` is that of the scene. Always false.
inline bool report_beyond_end(const std::string& what, Place place, Time length, Reading& reading)
{
    return reading.report.error(place, what + " after the scene, which ends at frame " + text_of(length),
                                "choose an earlier time, or make the scene longer with frames=…");
}

}
