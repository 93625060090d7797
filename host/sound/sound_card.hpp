#pragma once

#include "host/sound/deflection.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// Plays sound from its beginning to its end.
class SoundCard {
public:
    /// Is called for the next samples, all of them, on a thread of its own.
    using Next = std::function<void(std::span<StereoSample>)>;

    /// Plays at once. An empty `name` is the default device. If the device has another rate than
    /// `rate`, the sound is converted to it. Throws Failure where there is no such device.
    static std::unique_ptr<SoundCard> open(const std::string& name, std::uint32_t rate, Next next);
    /// The names of all devices. Throws Failure where there can be none.
    static std::vector<std::string> names();
    virtual ~SoundCard() = default;

protected:
    SoundCard() = default;
};

}
