#include "host/scene/skeleton/binding.hpp"

#include "host/scene/context/limits.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kfast::scene {
namespace {

double sum_of(const std::vector<WeightedBone>& bones)
{
    return std::accumulate(bones.begin(), bones.end(), 0.0,
                           [](double sum, const WeightedBone& bone) { return sum + bone.weight; });
}

void hand_out(int rest, int unit, const std::vector<double>& losses, Binding& binding)
{
    std::vector<std::size_t> order(binding.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return losses[i]; });
    for (std::size_t i = 0; rest > 0; ++i, rest -= unit)
        binding[order[i]].weight += unit;
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

Binding bound(std::vector<WeightedBone> bones, int unit)
{
    std::ranges::stable_sort(bones, std::ranges::greater{}, &WeightedBone::weight);
    bones.resize(std::min(bones.size(), max_bones_at_point));
    const double sum = sum_of(bones);
    Binding binding;
    std::vector<double> losses;
    int rest = kfb::skin::whole_weight;
    const int units = kfb::skin::whole_weight / unit;
    for (const WeightedBone& bone : bones) {
        const double weight = bone.weight / sum * units;
        binding.push_back({bone.bone, static_cast<int>(weight) * unit});
        losses.push_back(weight - std::floor(weight));
        rest -= binding.back().weight;
    }
    hand_out(rest, unit, losses, binding);
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
