#include "host/commands/devices/restart_text.hpp"

#include "host/commands/devices/playing_text.hpp"

#include <string_view>

namespace kfast {
namespace {

using Json = nlohmann::ordered_json;

std::string count_text(int count)
{
    if (count == 1)
        return "once";
    return count == 2 ? "twice in a row" : std::to_string(count) + " times in a row";
}

std::string while_text(const link::Restarts& restarts)
{
    if (restarts.home == link::Home::start)
        return "before anything played";
    return "while it played " + place_text(restarts.home, restarts.slot);
}

}

std::string restart_text(const link::Restarts& restarts)
{
    return "by its watchdog " + count_text(restarts.count) + ", " + (restarts.count > 1 ? "at last " : "") +
           while_text(restarts);
}

std::string safe_mode_text(const link::Restarts& restarts)
{
    const std::string_view plays =
        restarts.allows_built_in() ? "its built-in scene, if any" : "nothing by itself";
    const bool is_slot = restarts.home == link::Home::slot;
    return "plays " + std::string{plays} + "; 'kfast choose' what plays at its start" +
           (is_slot ? ", or 'kfast erase " + std::to_string(restarts.slot) + "'" : "");
}

Json restart_json(const link::Restarts& restarts)
{
    if (restarts.count == 0)
        return nullptr;
    const bool had_scene = restarts.home != link::Home::start;
    return {{"restarts", restarts.count},
            {"home", had_scene ? Json(home_text(restarts.home)) : Json()},
            {"slot", restarts.home == link::Home::slot ? Json(restarts.slot) : Json()},
            {"safe_mode", restarts.is_safe_mode()}};
}

}
