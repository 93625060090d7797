#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// What an SSD0323 makes of the bytes on its wires, stricter than the real one: the first mistake is kept as
/// error(), and nothing is decoded after it.
class Ssd0323Model {
public:
    static constexpr int width = 128;
    static constexpr int height = 64;

    /// Bytes that arrive with D/C low.
    void command(std::span<const std::byte> bytes);
    /// Bytes that arrive with D/C high.
    void data(std::span<const std::byte> bytes);

    /// What was wrong first, with the position of the byte among all bytes received.
    const std::optional<std::string>& error() const { return error_; }

    /// Levels 0..15, row by row, as they are on the glass: black until the display is on.
    std::array<std::uint8_t, width * height> picture() const;

private:
    struct Axis {
        int first = 0;
        int last = 0;
        int at = 0;
        bool given = false;
    };

    void take_command(std::uint8_t byte);
    void take_data(std::uint8_t byte);
    void execute();
    void select(Axis& axis, int limit, const char* name);
    void fail(const std::string& what);

    std::vector<std::uint8_t> pending_; ///< a command and those of its parameters that have come
    std::size_t parameters_ = 0;        ///< how many the pending command has
    Axis column_;                       ///< counted in bytes
    Axis row_;
    bool window_full_ = false;
    bool on_ = false;
    std::array<std::uint8_t, width * height> memory_{};
    std::size_t position_ = 0;
    std::optional<std::string> error_;
};

}
