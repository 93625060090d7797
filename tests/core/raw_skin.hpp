#pragma once

#include "tests/core/raw_scene.hpp"

#include <cstdint>
#include <random>
#include <vector>

/// Skins put together by hand (docs/format.md, "Skins").
namespace kfast::test {

struct RawInfluence {
    int bone = 0;
    int weight = 256; ///< of the last in a run it is not stored
    friend bool operator==(const RawInfluence&, const RawInfluence&) = default;
};

/// Of `points` points in a row.
struct RawRun {
    std::uint32_t points = 1;
    std::vector<RawInfluence> shares;
};

inline Bytes run_bytes(const RawRun& run)
{
    Bytes all = varint(4 * (run.points - 1) + static_cast<std::uint32_t>(run.shares.size()) - 1);
    for (const RawInfluence& share : run.shares)
        all = joined(
            {all, &share == &run.shares.back() ? bytes({share.bone}) : bytes({share.bone, share.weight})});
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

/// One to four of `bones` bones; weights are 1 … 256 and add up to 256.
inline std::vector<RawInfluence> random_shares(std::mt19937& random, int bones)
{
    std::vector<RawInfluence> shares(1 + random() % 4);
    int left = 256;
    for (RawInfluence& share : shares) {
        const int max = left - static_cast<int>(&shares.back() - &share);
        share.bone = static_cast<int>(random() % static_cast<unsigned>(bones));
        share.weight =
            &share == &shares.back() ? left : 1 + static_cast<int>(random() % static_cast<unsigned>(max));
        left -= share.weight;
    }
    return shares;
}

}
