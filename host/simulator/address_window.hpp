#pragma once

#include <optional>
#include <string>

namespace kfast {

/// Part of a controller's memory and the place in it that the next pixel goes to. Places are what the
/// controller counts: pixels, bytes of pixels or pages.
class AddressWindow {
public:
    enum class Axis { columns, rows };

    /// Sets one axis, where the last place that exists is `limit` - 1, and goes to the first place of both.
    /// Returns what is wrong with it, and changes nothing then.
    std::optional<std::string> set(Axis axis, int first, int last, int limit);
    /// Goes to the first place.
    void restart();
    /// Goes to the next place, first along `axis`.
    void advance(Axis axis);

    bool is_given() const { return columns_.is_given && rows_.is_given; }
    /// No place is left: the last one was passed.
    bool is_full() const { return is_full_; }
    bool is_begun() const { return is_begun_; }
    int column() const { return columns_.at; }
    int row() const { return rows_.at; }

private:
    struct Stretch {
        int first = 0;
        int last = 0;
        int at = 0;
        bool is_given = false;
    };

    Stretch columns_;
    Stretch rows_;
    bool is_begun_ = false;
    bool is_full_ = false;
};

}
