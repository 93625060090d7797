#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace kfast::test {

/// What is left to chance, without std's distributions, which differ between libraries.
class Dice {
public:
    explicit Dice(std::mt19937& random) : random_{random} {}

    /// 0 … `limit` − 1
    std::size_t below(std::size_t limit) { return random_() % limit; }
    /// `min` … `max`
    int within(int min, int max)
    {
        return min + static_cast<int>(below(static_cast<unsigned>(max - min + 1)));
    }
    /// One time in three.
    bool sometimes() { return below(3) == 0; }
    std::uint8_t byte() { return static_cast<std::uint8_t>(random_()); }
    /// Of any length that the format has room for.
    std::string name() { return std::string(static_cast<std::size_t>(within(1, 255)), 'n'); }

private:
    std::mt19937& random_;
};

}
