#pragma once

#include "host/preview/controls/preview_key.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace kfast {

/// One step of somebody who is not there: a key, or what a mouse would do.
struct ScriptStep {
    enum class Kind {
        key,
        frame,  ///< the time line is touched at frame `number`
        select, ///< the item that is called `text`; none if that is empty
        open,   ///< the file `text` is dropped
        wait,   ///< `number` seconds pass
    };
    Kind kind = Kind::key;
    PreviewKey key = PreviewKey::help;
    double number = 0;
    std::string text = {};
};

/// A key by its name (preview_key), or "frame=12.5", "select=lamp", "open=FILE", "wait=0.5".
std::optional<ScriptStep> script_step(std::string_view word);

}
