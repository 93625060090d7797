#pragma once

#include "firmware/link/link_service.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

namespace kfast::test {

/// A cable, and what is on its way in it.
class PretendPipe {
public:
    std::optional<Report> take()
    {
        if (to_device.empty())
            return std::nullopt;
        const auto report = to_device.front();
        to_device.pop_front();
        return report;
    }
    bool send(const Report& report)
    {
        if (!connected || to_computer.size() >= room)
            return false;
        to_computer.push_back(report);
        return true;
    }
    bool is_connected() const { return connected; }
    std::uint32_t connections() const { return count; }

    void unplug()
    {
        connected = false;
        to_device.clear();
        to_computer.clear();
    }
    void plug_in()
    {
        unplug();
        connected = true;
        ++count;
    }

    std::deque<Report> to_device;
    std::deque<Report> to_computer;
    std::size_t room = 4;
    bool connected = false;
    std::uint32_t count = 0;
};

}
