#include "host/scene/skeleton/binding.hpp"

#include "host/scene/context/limits.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kfast::scene {
namespace {

constexpr int whole = 256;

double sum_of(const std::vector<WeightedBone>& bones)
{
    return std::accumulate(bones.begin(), bones.end(), 0.0,
                           [](double sum, const WeightedBone& bone) { return sum + bone.weight; });
}

void hand_out(int rest, const std::vector<double>& losses, Binding& binding)
{
    std::vector<std::size_t> order(binding.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return losses[i]; });
    for (int i = 0; i < rest; ++i)
        ++binding[order[static_cast<std::size_t>(i)]].weight;
}

void add(const Binding& binding, double share, std::vector<WeightedBone>& bones)
{
    for (const BoneWeight& own : binding) {
        auto known = std::ranges::find(bones, own.bone, &WeightedBone::bone);
        if (known == bones.end())
            known = bones.insert(bones.end(), {own.bone, 0});
        known->weight += share * own.weight;
    }
}

}

Binding bound(std::vector<WeightedBone> bones)
{
    std::ranges::stable_sort(bones, std::ranges::greater{}, &WeightedBone::weight);
    bones.resize(std::min(bones.size(), max_bones_at_point));
    const double sum = sum_of(bones);
    Binding binding;
    std::vector<double> losses;
    int rest = whole;
    for (const WeightedBone& bone : bones) {
        const double weight = bone.weight / sum * whole;
        binding.push_back({bone.bone, static_cast<int>(weight)});
        losses.push_back(weight - std::floor(weight));
        rest -= binding.back().weight;
    }
    hand_out(rest, losses, binding);
    std::erase_if(binding, [](const BoneWeight& bone) { return bone.weight == 0; });
    std::ranges::stable_sort(binding, std::ranges::greater{}, &BoneWeight::weight);
    return binding;
}

Binding mixed(const Binding& a, const Binding& b, double share)
{
    std::vector<WeightedBone> bones;
    add(a, 1 - share, bones);
    add(b, share, bones);
    return bound(std::move(bones));
}

}
