#pragma once

#include "core/scene/item_view.hpp"
#include "host/scene/model.hpp"

namespace kfast {

/// What carries `object`.
inline Deformer deformer_of(const scene::Object& object)
{
    if (object.skin)
        return Deformer::bones;
    return object.backbone_keys.empty() ? Deformer::none : Deformer::backbones;
}

}
