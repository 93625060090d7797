#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"

#include <optional>
#include <vector>

namespace kfast::scene {

/// What an object says about the bones that deform it.
struct WrittenSkin {
    const kdl::Value* skeleton = nullptr; ///< of its property "skin"
    const kdl::Value* bone = nullptr;     ///< of its property "bone"
    const kdl::Value* bones = nullptr;    ///< of its property "bones"
    bool turns_changes = false;           ///< of its property "change"
    const kdl::Node* weights = nullptr;
    SourceSpan place; ///< of the object
};

/// `keys` are those of the object. Nothing if there is no skin, or none that can be used; what is wrong is
/// reported.
std::optional<Skin> read_skin(const WrittenSkin& written, const std::vector<Key>& keys,
                              SceneContext& context);

}
