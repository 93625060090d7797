#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::test {

/// The folder that KFAST_STAND_IN names. Below it lie the devices that this program is to believe in:
/// dev/gpiochip0, dev/spidev0.0, sys/module/spidev/parameters/bufsiz, and wires, where all that happens is
/// written.
const std::string& stand_in_root();

/// Where `path` lies below the root if it is about GPIO or SPI, or is /dev itself; else empty.
std::string below_root(std::string_view path);

/// The lines of a description, each a word and what belongs to it: "taken 25 spi0 CS1".
std::multimap<std::string, std::string> described(const std::string& file);

/// The first number that `word` has there, or `otherwise`.
long number_of(const std::multimap<std::string, std::string>& description, const std::string& word,
               long otherwise);

}
