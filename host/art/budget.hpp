#pragma once

#include <cstddef>
#include <string>

namespace kfast::art {

/// Limits what an importer may build: a small file can ask for any amount, by uses of uses. Each throws
/// Failure when its limit is exceeded.
class Budget {
public:
    static constexpr std::size_t max_nodes = 65'535;
    static constexpr std::size_t max_points = std::size_t{1} << 21; ///< in all keys of drawings
    static constexpr std::size_t max_keys = std::size_t{1} << 20;   ///< of channels
    /// Points of drawings, each time they are computed to find keys.
    static constexpr std::size_t max_computed_points = std::size_t{1} << 26;
    /// Values of JSON, tags of XML: a parser takes up to 100 bytes for each, however short its text is.
    static constexpr std::size_t max_parsed = std::size_t{1} << 21;
    static constexpr int deepest = 64; ///< nested groups, layers and uses

    void take_node();
    void take_points(std::size_t count);
    void take_keys(std::size_t count);
    void take_computed_points(std::size_t count);
    std::size_t computed_points_left() const { return max_computed_points - computed_points_; }
    static void check_depth(int depth);
    /// Asked before the file of that name is parsed; `noun` is what there are `count` of.
    static void check_parsed(const std::string& file, std::size_t count, const char* noun);

private:
    std::size_t nodes_ = 0;
    std::size_t points_ = 0;
    std::size_t keys_ = 0;
    std::size_t computed_points_ = 0;
};

}
