#pragma once

#include "host/lottie/values/member.hpp"
#include "host/text/source.hpp"

#include <string>

namespace kfast::lottie {

/// How deep lists and objects may lie in each other.
inline constexpr int deepest_json = 256;

/// Throws Failure with line and column where the text is no JSON, or too deep.
Json parse_json(const SourceText& source);

/// Where `place` is within `root`, such as layers[3].ks.p; empty if it is `root`, or not in it.
std::string path_to(const Json& root, const Json* place);

}
