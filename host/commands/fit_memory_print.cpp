#include "host/commands/fit_memory_print.hpp"

#include "host/fit/wording.hpp"

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

std::string fit_line(const std::string& name, const std::string& text)
{
    return "  " + name + std::string(name.size() < 12 ? 12 - name.size() : 1, ' ') + text + '\n';
}

std::string memory_line(const std::string& name, std::size_t used, std::size_t available,
                        const std::string& parts)
{
    return fit_line(name, std::to_string(used) + " of " + fit::bytes_text(available) + ": " + parts);
}

}
