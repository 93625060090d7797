#pragma once

#include "host/fit/memory_need.hpp"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace kfast {

using Json = nlohmann::ordered_json;

Json flash_facts(const fit::FlashNeed& need, std::size_t available);
/// `buffers` is what the two of them are called.
Json ram_facts(const fit::RamNeed& need, std::size_t available, const char* buffers);

/// A row of the table for people.
std::string fit_line(const std::string& name, const std::string& text);
std::string memory_line(const std::string& name, std::size_t used, std::size_t available,
                        const std::string& parts);

}
