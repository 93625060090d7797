#pragma once

#include "host/picture/picture.hpp"

#include <filesystem>
#include <map>

namespace kfast {

/// What another panel has shown of a scene, frame by frame: a folder of PNG files named by the numbers of
/// their frames, as `kfast render --all` and tests/emulation/board_test.py write them. Some may be missing.
class PanelPictures {
public:
    /// Other files are skipped. Throws Failure where there is no such picture, where one cannot be read
    /// or has another size than `panel`, and where they would take too much memory.
    PanelPictures(const std::filesystem::path& folder, Size panel);

    /// What it showed at `frame`: the latest picture that is not after it, or the first of all.
    const Picture& at(int frame) const;

private:
    void read(const std::filesystem::path& file, int frame, Size panel);

    std::map<int, Picture> pictures_; ///< not empty
};

}
