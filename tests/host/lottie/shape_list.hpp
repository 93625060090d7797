#pragma once

#include "host/lottie/shapes/shapes.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace kfast::test {

/// What a shape layer named "layer" draws.
struct ReadShapes {
    art::Losses losses;
    std::vector<art::Node> nodes;
};

inline ReadShapes read_shapes(const std::string& items)
{
    ReadShapes result;
    art::Budget budget;
    const lottie::Json json = lottie::Json::parse('[' + items + ']');
    result.nodes = lottie::read_shapes(json, {budget, result.losses, {}, "layer"});
    return result;
}

inline const art::Shape& shape(const art::Node& node) { return std::get<art::Shape>(node.content); }
inline const std::vector<art::Node>& inside(const art::Node& node)
{
    return std::get<art::Group>(node.content).nodes;
}

inline const std::string square = R"({"ty": "rc", "nm": "square", "p": {"k": [10, 20]}, "s": {"k": [8, 6]}})";
inline const std::string line =
    R"({"ty": "sh", "nm": "line", "ks": {"k": {"c": false, "v": [[0, 0], [100, 0]], "i": [[0, 0], [0, 0]], "o": [[0, 0], [0, 0]]}}})";
inline const std::string red = R"({"ty": "fl", "nm": "red", "c": {"k": [1, 0, 0, 1]}})";
inline const std::string blue = R"({"ty": "fl", "nm": "blue", "c": {"k": [0, 0, 1, 1]}})";
inline const std::string stroke =
    R"({"ty": "st", "nm": "stroke", "c": {"k": [0, 1, 0, 1]}, "w": {"k": 2}, "lc": 1})";

/// A property that goes evenly from one value at frame 0 to another one at frame 10.
inline std::string even(const std::string& from, const std::string& to)
{
    return R"({"a": 1, "k": [{"t": 0, "s": )" + from +
           R"(, "o": {"x": [0], "y": [0]}, "i": {"x": [1], "y": [1]}},
                             {"t": 10, "s": )" +
           to + "}]}";
}

}
