#pragma once

#include "core/scene/item_view.hpp"
#include "host/scene/model.hpp"

namespace kfast {

/// What carries `object`.
inline Carrier carrier_of(const scene::Object& object)
{
    if (object.skin)
        return Carrier::bones;
    return object.backbone_keys.empty() ? Carrier::none : Carrier::backbones;
}

}
