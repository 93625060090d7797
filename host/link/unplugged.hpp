#pragma once

#include "host/program/failure.hpp"

namespace kfast {

inline Failure unplugged()
{
    return Failure{"the device is gone: plug it in again, and ask once more", ExitStatus::unplugged};
}

inline Failure takes_nothing()
{
    return Failure{"the device takes no report: unplug it, plug it in again, and ask once more",
                   ExitStatus::timed_out};
}

}
