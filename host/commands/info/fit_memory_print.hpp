#pragma once

#include "host/fit/scene_needs.hpp"
#include "host/fit/target.hpp"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace kfast {

using Json = nlohmann::ordered_json;

Json flash_facts(const fit::FlashNeed& need, std::size_t available);
/// What is there for scenes, next to the firmware.
/// Those that the player has; null if it has all.
Json feature_facts(const fit::FlashNeed& need);
Json room_facts(const fit::FlashNeed& flash, const fit::RamNeed& ram, const fit::Target& target);
/// The parts of what is reserved, by their names.
Json reserved_facts(const fit::Target& target);
/// `buffers` is what the two of them are called.
Json ram_facts(const fit::RamNeed& need, std::size_t available, const char* buffers);

/// A row of the table for people.
std::string fit_line(const std::string& name, const std::string& text);
/// What the scene takes of the room for scenes, and apart from that what the firmware takes. `buffers` as
/// above.
std::string memory_lines(const fit::FlashNeed& flash, const fit::RamNeed& ram, const fit::Target& target,
                         const char* buffers);

}
