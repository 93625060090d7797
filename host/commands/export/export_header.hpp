#pragma once

#include <string>
#include <string_view>

namespace kfast {

/// `name`, if it can be the name of an array in C and in C++, also with a few letters after it; else throws
/// CLI::ValidationError for the option --array-name.
const std::string& checked_c_name(const std::string& name);

/// The name of an array made from that of a file: "robot_eyes" from "art/robot-eyes.kfast".
/// Throws Failure when that makes none.
std::string c_name_for(const std::string& file);

}
