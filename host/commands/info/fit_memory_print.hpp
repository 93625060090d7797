#pragma once

#include "host/fit/scene_needs.hpp"
#include "host/fit/target.hpp"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace kfast {

using Json = nlohmann::ordered_json;

Json flash_facts(const fit::FlashNeed& need, std::size_t available);
/// The features of the player that a board has for scenes, next to the rest of the firmware;
/// null if it has all.
Json feature_facts(const fit::FlashNeed& need);
Json room_facts(const fit::FlashNeed& flash, const fit::RamNeed& ram, const fit::Target& target);
/// The parts of what is reserved, by their names.
Json reserved_facts(const fit::Target& target);
/// `buffers` is the name for the two of them.
Json ram_facts(const fit::RamNeed& need, std::size_t available, const char* buffers);

/// A row of the table for people.
std::string fit_line(const std::string& name, const std::string& text);
/// What the scene needs of the room for scenes, and separately what the firmware needs. `buffers` as in
/// ram_facts().
std::string memory_lines(const fit::FlashNeed& flash, const fit::RamNeed& ram, const fit::Target& target,
                         const char* buffers);

}
