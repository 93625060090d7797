#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <vector>

namespace kfast::test {

/// A device as hidapi lists it.
struct HidEntry {
    std::string path;
    unsigned short usage_page = 0xFF00;
    const wchar_t* serial = nullptr;
};

/// What a call returns, and what errno is then.
struct HidResult {
    int value = 0;
    int error = 0;
};

/// The hidapi of this program, which takes the place of the real one.
struct PretendHidapi {
    std::vector<HidEntry> plugged_in;
    bool opens = true;
    std::deque<HidResult> writes; ///< one for each call
    std::deque<HidResult> reads;
    std::vector<std::vector<unsigned char>> written;
    int open = 0; ///< devices, and lists of them, that are not closed yet
};

/// Of the test that runs.
PretendHidapi& pretend_hidapi();

}
