#pragma once

#include <string>

namespace kfast::test {

/// From now on `words` are written if the program ends by a broken demand or expectation, by what a sanitizer
/// finds, or because it has used the processor for a minute more: a program that tries many inputs tells
/// which one it is at.
void say_if_it_ends(std::string words);

}
