#pragma once

#include "core/pose/scene_state.hpp"
#include "core/scene/item_view.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <string>
#include <vector>

namespace kfast {

/// One key of a quantity, in the words of the scene language.
struct QuantityKey {
    Time time;
    std::string value = {}; ///< empty for drawings, backbones and bones
    std::string law = {};   ///< from here to the next key; empty where there is none and where values jump

    friend bool operator==(const QuantityKey&, const QuantityKey&) = default;
};

/// What keys change of an item: its drawings ("shape"), "backbones" or "bones" that deform it, or a property.
/// Where scale-x and scale-y are the same, they are one, "scale".
struct Quantity {
    std::string name;
    Driver driver = {};
    std::vector<QuantityKey> keys = {}; ///< in order, at least one
};

std::vector<Quantity> quantities_of(const SceneView& scene, const ItemView& item);

/// The two keys around a time of their driver; null where there is none on that side. At a key it is the one
/// before.
struct KeysAround {
    const QuantityKey* before = nullptr;
    const QuantityKey* after = nullptr;
};

KeysAround keys_around(const Quantity& quantity, Time moment);

/// A property of an item at a time: "rotate", "30".
struct ItemValue {
    std::string name;
    std::string value;
    bool has_keys = false; ///< more than one of them
};

/// An item at a time, for display.
struct ItemFacts {
    struct Way {
        std::string name;  ///< of a quantity, "y"; of one that goes by an input "y by gaze"
        std::string begin; ///< the key before: "10: 40, accelerate"; empty if there is none
        std::string end;   ///< the key after, in the same way
    };
    /// Position, size, direction and opacity, what an object is painted with, and all else that has a track.
    std::vector<ItemValue> values;
    std::vector<Way> ways; ///< of all quantities with more than one key
};

/// `on_panel` has been moved to the time.
ItemFacts facts_at(const SceneOnPanel& on_panel, const ItemView& item, const SceneTime& moment);

}
