#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace kfast {

/// As long as a line that tells of progress stays at least.
inline constexpr std::chrono::milliseconds between_drawings{100};

/// One line at the end of standard error, if that is a terminal, that is written over and over. It goes away
/// with its owner.
class StatusLine {
public:
    StatusLine();
    ~StatusLine();
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    bool is_seen() const { return is_seen_; }
    void show(const std::string& text);

private:
    bool is_seen_;
    std::size_t width_ = 0; ///< of what was shown
};

}
