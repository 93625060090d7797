#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/key_reader.hpp"

#include <vector>

namespace kfast::scene {

/// The keys of one item or symbol, in the order of their moments.
class KeyList {
public:
    KeyList(KeyHolder holder, const KeyDriver& driver, SceneContext& context)
        : holder_{holder}, driver_{driver}, context_{context}
    {
    }

    /// `node` must live as long as the keys. Whether it was a key at a moment of its own.
    bool read(const kdl::Node& node);
    /// After the last key: all of them. Their laws are looked at, and how far they reach in time.
    std::vector<ItemKey> take();

private:
    bool in_order(const ItemKey& key);

    KeyHolder holder_;
    KeyDriver driver_;
    SceneContext& context_;
    std::vector<ItemKey> keys_;
};

}
