#include "tests/host/compiler/random_skin.hpp"

#include "host/scene/skeleton/binding.hpp"

namespace kfast::test {
namespace {

scene::Binding random_binding(Dice& dice, std::size_t bones)
{
    std::vector<scene::WeightedBone> weights{{dice.below(bones), 1}};
    for (std::size_t i = 0; i < bones; ++i)
        if (i != weights[0].bone && dice.sometimes())
            weights.push_back({i, dice.within(1, 1000) / 1000.0});
    return scene::bound(weights);
}

}

scene::Skin random_skin(Dice& dice, const std::vector<scene::Bones>& skeletons, std::size_t skeleton,
                        const scene::Drawing& first)
{
    scene::Skin skin{.bones = skeleton, .bindings = {}, .place = {}};
    const std::size_t bones = skeletons[skeleton].bones.size();
    for (std::size_t i = 0; i < point_count(first); ++i)
        skin.bindings.push_back(i > 0 && dice.sometimes() ? skin.bindings.back()
                                                          : random_binding(dice, bones));
    return skin;
}

}
