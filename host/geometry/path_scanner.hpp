#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace kfast::scene {

/// Cuts SVG path data into commands, numbers and flags.
class PathScanner {
public:
    explicit PathScanner(std::string_view data) : data_{data} {}

    std::size_t offset() const { return offset_; }
    bool at_end() const { return offset_ == data_.size(); }
    /// Whether a number begins here.
    bool at_number() const;

    void skip_space();
    /// White space with at most one comma in it. Returns whether there was a comma.
    bool skip_separator();

    /// Takes any byte. Only when not at_end().
    char take() { return data_[offset_++]; }
    /// Takes digits with at most one point, a sign before and an exponent after them. Nothing (and no step
    /// ahead) when no number begins here or it is too large or too small for a double.
    std::optional<double> number();
    /// Takes a single 0 or 1, whatever follows it.
    std::optional<bool> flag();

private:
    char at(std::size_t offset) const { return offset < data_.size() ? data_[offset] : '\0'; }
    bool digit_at(std::size_t offset) const { return at(offset) >= '0' && at(offset) <= '9'; }
    bool sign_at(std::size_t offset) const { return at(offset) == '+' || at(offset) == '-'; }
    std::size_t digits_end(std::size_t offset) const;
    std::size_t number_end() const;

    std::string_view data_;
    std::size_t offset_ = 0;
};

}
