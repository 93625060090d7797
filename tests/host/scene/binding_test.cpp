#include "host/scene/skeleton/binding.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace kfast::test {

using scene::Binding;
using scene::bound;
using scene::coarsely_bound;
using scene::mixed;

TEST_CASE("weights are rounded so that they add up, and what is missing goes to those that lost most")
{
    CHECK(bound({{3, 7}}) == Binding{{3, 65'536}});
    CHECK(bound({{0, 1}, {1, 1}}) == Binding{{0, 32'768}, {1, 32'768}});
    CHECK(bound({{0, 1}, {1, 1}, {2, 1}}) == Binding{{0, 21'846}, {1, 21'845}, {2, 21'845}});
    CHECK(bound({{0, 1}, {1, 2}}) == Binding{{1, 43'691}, {0, 21'845}});
    CHECK(bound({{0, 1}, {1, 0}, {2, 1e-9}}) == Binding{{0, 65'536}});
}

TEST_CASE("weights in a unit of their own are multiples of it")
{
    CHECK(coarsely_bound({{0, 1}, {1, 1}, {2, 1}}) == Binding{{0, 86 * 256}, {1, 85 * 256}, {2, 85 * 256}});
    CHECK(coarsely_bound({{0, 1}, {1, 1e-4}}) == Binding{{0, 65'536}});
}

TEST_CASE("the four heaviest bones are kept")
{
    CHECK(bound({{0, 1}, {1, 5}, {2, 5}, {3, 1}, {4, 5}, {5, 1}}) ==
          Binding{{1, 20'480}, {2, 20'480}, {4, 20'480}, {0, 4096}});
}

TEST_CASE("weights always add up, each at least 1, the heaviest first")
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
        CHECK(sum == 65'536);
        CHECK(std::ranges::is_sorted(binding, std::ranges::greater{}, &scene::BoneWeight::weight));
    }
}

TEST_CASE("points between others mix what these follow")
{
    CHECK(mixed({{0, 65'536}}, {{1, 65'536}}, 0.25) == Binding{{0, 49'152}, {1, 16'384}});
    CHECK(mixed({{0, 32'768}, {1, 32'768}}, {{1, 65'536}}, 0.5) == Binding{{1, 49'152}, {0, 16'384}});
    CHECK(mixed({{0, 16'384}, {1, 16'384}, {2, 16'384}, {3, 16'384}}, {{4, 65'536}}, 0.5) ==
          Binding{{4, 37'449}, {0, 9363}, {1, 9362}, {2, 9362}});
}
}
