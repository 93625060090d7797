#pragma once

#include "firmware/chip/microseconds.hpp"

#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
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

/// Keeps in words what goes over it, and what passes in between: one line for
///
///     command 81 70                         the bytes with D/C low
///     command 2A | 00 00 00 EF              those after | with D/C high
///     pixels 12 34
///     pause 120000                          microseconds
class RecordingBus {
public:
    void command(std::span<const std::byte> bytes) { lines.push_back("command" + hex(bytes)); }
    void parameters(std::span<const std::byte> bytes) { lines.back() += " |" + hex(bytes); }
    void start_data(std::span<const std::byte> bytes) { lines.push_back("pixels" + hex(bytes)); }
    bool busy() const { return is_busy; }

    /// What a panel is given to let time pass.
    auto pause()
    {
        return [this](Microseconds time) { lines.push_back("pause " + std::to_string(time.count)); };
    }

    std::vector<std::string> lines;
    bool is_busy = false;

protected:
    static std::string hex(std::span<const std::byte> bytes)
    {
        std::string text;
        for (const std::byte byte : bytes) {
            char two_digits[4];
            std::snprintf(two_digits, sizeof two_digits, " %02X", std::to_integer<unsigned>(byte));
            text += two_digits;
        }
        return text;
    }
};

/// Likewise, with words: `words 34 12`, the bytes as they lie in memory.
class RecordingWordBus : public RecordingBus {
public:
    void start_words(std::span<const std::byte> words) { lines.push_back("words" + hex(words)); }
};

}
