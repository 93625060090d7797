#pragma once

#include <string_view>

namespace kfast {

/// The text of starter.kfast: a small scene with comments, from which one may go on.
extern const std::string_view starter_scene;

}
