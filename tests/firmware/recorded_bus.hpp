#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace kfast::test {

/// Keeps what is sent over it, one entry a call.
class RecordedBus {
public:
    struct Transfer {
        bool data = false; ///< the level of D/C
        std::vector<std::byte> bytes;
        friend bool operator==(const Transfer&, const Transfer&) = default;
    };

    void command(std::span<const std::byte> bytes) { sent.push_back({false, {bytes.begin(), bytes.end()}}); }
    void parameters(std::span<const std::byte> bytes)
    {
        sent.push_back({true, {bytes.begin(), bytes.end()}});
    }
    void start_data(std::span<const std::byte> bytes)
    {
        sent.push_back({true, {bytes.begin(), bytes.end()}});
    }
    bool busy() const { return is_busy; }

    std::vector<Transfer> sent;
    bool is_busy = false;
};

}
