#pragma once

#include "core/math/point.hpp"
#include "host/import/import_scene.hpp"
#include "host/import/loss_list.hpp"

#include <cstddef>
#include <string>

namespace kfast {

/// What became of a file of another program.
struct ImportReport {
    const std::string& file;
    const std::string& scene; ///< the name of the text that was written
    const importing::Imported& imported;
    Size canvas;
    std::size_t block_bytes = 0; ///< of memory, on a panel like the canvas
    bool is_size_chosen = false;
};

/// For a terminal, with line ends.
std::string import_text(const ImportReport& report, importing::ListLength length);

/// For programs: all of it, as a JSON object.
std::string import_json(const ImportReport& report);

}
