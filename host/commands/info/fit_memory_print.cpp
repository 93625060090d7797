#include "host/commands/info/fit_memory_print.hpp"

#include "host/fit/wording.hpp"
#include "host/text/characters.hpp"
#include "host/words/scene_words.hpp"

namespace kfast {

Json flash_facts(const fit::FlashNeed& need, std::size_t available)
{
    return {{"player", need.player},
            {"scene", need.scene},
            {"reserved", need.reserved},
            {"used", need.sum()},
            {"available", available}};
}

Json ram_facts(const fit::RamNeed& need, std::size_t available, const char* buffers)
{
    return {{"block", need.block},   {buffers, need.bands},       {"static", need.fixed},
            {"stack", need.stack},   {"reserved", need.reserved}, {"used", need.sum()},
            {"available", available}};
}

Json feature_facts(const fit::FlashNeed& need)
{
    return need.features ? Json(feature_names(*need.features)) : Json(nullptr);
}

Json room_facts(const fit::FlashNeed& flash, const fit::RamNeed& ram, const fit::Target& target)
{
    return {{"scene", flash.room(target.flash)}, {"block", ram.room(target.ram)}};
}

Json reserved_facts(const fit::Target& target)
{
    Json parts = Json::array();
    for (const auto& [name, flash, ram] : target.reserved)
        parts.push_back({{"name", name}, {"flash", flash}, {"ram", ram}});
    return parts;
}

std::string fit_line(const std::string& name, const std::string& text)
{
    return "  " + name + std::string(name.size() < 12 ? 12 - name.size() : 1, ' ') + text + '\n';
}

std::string memory_lines(const fit::FlashNeed& flash, const fit::RamNeed& ram, const fit::Target& target,
                         const char* buffers)
{
    using namespace fit;
    return fit_line("scene", memory_text(flash.scene) + " of " + memory_text(flash.room(target.flash)) +
                                 " for scenes") +
           fit_line("block", memory_text(ram.block) + " of " + memory_text(ram.room(target.ram)) +
                                 " of RAM for scenes") +
           fit_line("firmware", visible(firmware_flash_text(flash, target))) +
           fit_line("", visible(firmware_ram_text(ram, target, buffers)));
}
}
