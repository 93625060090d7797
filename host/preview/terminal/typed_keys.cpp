#include "host/preview/terminal/typed_keys.hpp"

#include <array>

namespace kfast {
namespace {

/// What is sent for keys that are no letters, the longer first.
struct Sent {
    std::string_view bytes;
    std::string_view name;
};

constexpr std::array sent{
    Sent{"\x1b[A", "up"}, Sent{"\x1b[B", "down"},      Sent{"\x1b[C", "right"}, Sent{"\x1b[D", "left"},
    Sent{"\x1bOA", "up"}, Sent{"\x1bOB", "down"},      Sent{"\x1bOC", "right"}, Sent{"\x1bOD", "left"},
    Sent{" ", "space"},   Sent{"\x1b[Z", "shift-tab"}, Sent{"\t", "tab"},       Sent{"\r", "enter"},
    Sent{"\n", "enter"},
};

/// A key by itself; else it begins another one, or says that Alt is held with it.
bool is_escape(std::string_view bytes)
{
    const std::string_view behind = bytes.substr(1);
    return bytes.front() == '\x1b' &&
           (behind.empty() ||
            (behind.starts_with('\x1b') && !behind.starts_with("\x1b[") && !behind.starts_with("\x1bO")));
}

Sent first_key(std::string_view bytes)
{
    for (const Sent& key : sent)
        if (bytes.starts_with(key.bytes))
            return key;
    const std::string_view letter = bytes.substr(0, 1);
    return {letter, is_escape(bytes) ? "escape" : letter};
}

}

std::vector<PreviewKey> typed_keys(std::string_view bytes)
{
    std::vector<PreviewKey> keys;
    while (!bytes.empty()) {
        const Sent first = first_key(bytes);
        if (const auto key = preview_key(first.name))
            keys.push_back(*key);
        bytes.remove_prefix(first.bytes.size());
    }
    return keys;
}

}
