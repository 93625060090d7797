#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/key_reader.hpp"

#include <vector>

namespace kfast::scene {

/// The keys of one item or symbol, in the order of their times.
class KeyList {
public:
    KeyList(KeyHolder holder, const KeyDriver& driver, SceneContext& context)
        : holder_{holder}, driver_{driver}, context_{context}
    {
    }

    /// `node` must live as long as the keys. Returns whether it was a key at a time of its own.
    bool read(const kdl::Node& node);
    /// After the last key: returns all of them. Checks their laws, and how far they reach in time.
    std::vector<ItemKey> take();

private:
    bool in_order(const ItemKey& key);

    KeyHolder holder_;
    KeyDriver driver_;
    SceneContext& context_;
    std::vector<ItemKey> keys_;
};

}
