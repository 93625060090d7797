#pragma once

#include "tests/core/raw_scene.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

/// Skins put together by hand (docs/format.md, "Skins").
namespace kfast::test {

struct RawInfluence {
    int bone = 0;
    int weight = 65'536; ///< of the last in a run it is not stored
    friend bool operator==(const RawInfluence&, const RawInfluence&) = default;
};

/// Of `points` points in a row.
struct RawRun {
    std::uint32_t points = 1;
    std::vector<RawInfluence> shares;
};

/// Weights in one byte where that suffices.
inline Bytes run_bytes(const RawRun& run)
{
    const bool is_fine =
        std::ranges::any_of(run.shares, [](const RawInfluence& share) { return share.weight % 256 != 0; });
    Bytes all =
        varint(8 * (run.points - 1) + 4 * is_fine + static_cast<std::uint32_t>(run.shares.size()) - 1);
    for (const RawInfluence& share : run.shares) {
        const Bytes bone = bytes({share.bone});
        const Bytes weight =
            is_fine ? bytes({share.weight % 256, share.weight / 256}) : bytes({share.weight / 256});
        all = joined({all, bone, &share == &run.shares.back() ? Bytes{} : weight});
    }
    return all;
}

/// `at_rest` is 0, or 1 and an offset.
inline Bytes skin_bytes(const std::vector<RawRun>& runs, std::uint32_t at_rest = 0)
{
    Bytes all = varint(at_rest);
    for (const RawRun& run : runs)
        all = joined({all, run_bytes(run)});
    return all;
}

/// One to four of `bones` bones; weights are multiples of 256 or not, at least 1, and add up to 65,536.
inline std::vector<RawInfluence> random_shares(std::mt19937& random, int bones)
{
    std::vector<RawInfluence> shares(1 + random() % 4);
    const int unit = random() % 2 == 0 ? 1 : 256;
    int left = 65'536 / unit;
    for (RawInfluence& share : shares) {
        const int max = left - static_cast<int>(&shares.back() - &share);
        share.bone = static_cast<int>(random() % static_cast<unsigned>(bones));
        share.weight =
            &share == &shares.back() ? left : 1 + static_cast<int>(random() % static_cast<unsigned>(max));
        left -= share.weight;
        share.weight *= unit;
    }
    return shares;
}

}
