#pragma once

#include "host/text/characters.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace kfast {

/// For standard output, with its line end. Bytes that are no UTF-8, as names may have, are replaced, and what
/// is not printable is escaped: "\u202e".
inline std::string json_text(const nlohmann::ordered_json& json)
{
    return printable_json(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + '\n';
}

}
