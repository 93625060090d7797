#include "host/scene/skeleton/binding.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace kfast::test {

using scene::Binding;
using scene::bound;
using scene::mixed;

TEST_CASE("weights are rounded so that they add up, and what is missing goes to those that lost most")
{
    CHECK(bound({{3, 7}}) == Binding{{3, 256}});
    CHECK(bound({{0, 1}, {1, 1}}) == Binding{{0, 128}, {1, 128}});
    CHECK(bound({{0, 1}, {1, 1}, {2, 1}}) == Binding{{0, 86}, {1, 85}, {2, 85}});
    CHECK(bound({{0, 1}, {1, 2}}) == Binding{{1, 171}, {0, 85}});
    CHECK(bound({{0, 1}, {1, 0}, {2, 1e-9}}) == Binding{{0, 256}});
}

TEST_CASE("the four heaviest bones are kept")
{
    CHECK(bound({{0, 1}, {1, 5}, {2, 5}, {3, 1}, {4, 5}, {5, 1}}) ==
          Binding{{1, 80}, {2, 80}, {4, 80}, {0, 16}});
}

TEST_CASE("weights always add up to 256, each at least 1, the heaviest first")
{
    std::mt19937 random{9};
    for (int round = 0; round < 2000; ++round) {
        std::vector<scene::WeightedBone> bones;
        for (std::size_t i = 0; i <= random() % 6; ++i)
            bones.push_back({i, std::uniform_real_distribution<double>{0.0001, 1}(random)});
        const Binding binding = bound(bones);
        CHECK(binding.size() <= 4);
        int sum = 0;
        for (const scene::BoneWeight& share : binding) {
            CHECK(share.weight >= 1);
            sum += share.weight;
        }
        CHECK(sum == 256);
        CHECK(std::ranges::is_sorted(binding, std::ranges::greater{}, &scene::BoneWeight::weight));
    }
}

TEST_CASE("points between others mix what these follow")
{
    CHECK(mixed({{0, 256}}, {{1, 256}}, 0.25) == Binding{{0, 192}, {1, 64}});
    CHECK(mixed({{0, 128}, {1, 128}}, {{1, 256}}, 0.5) == Binding{{1, 192}, {0, 64}});
    CHECK(mixed({{0, 64}, {1, 64}, {2, 64}, {3, 64}}, {{4, 256}}, 0.5) ==
          Binding{{4, 146}, {0, 37}, {1, 37}, {2, 36}});
}
}
