#pragma once

#include "core/chain_edge.hpp"
#include "core/layer.hpp"
#include "core/outline_store.hpp"

#include <cstdint>

namespace kfast {

/// To the upper end of the edge of the chain that has `chain.passed` others above it.
void enter_edge(const OutlineStore& store, Chain& chain);

/// Goes down over the chains of a layer and keeps a list of those that it stands in: it begins with
/// layer.active. The store and the layer must outlive it.
class SweepLine {
public:
    SweepLine(OutlineStore& store, Layer& layer) : store_{store}, layer_{layer} {}

    /// Takes up the chains that begin at `subrow` or above it, in front of the others.
    void take_up(std::int32_t subrow);
    /// To the upper end of the chain.
    void begin(Chain& chain);
    /// Moves the chain down to `subrow`. Whether anything of it is left below.
    bool move_to(Chain& chain, std::int32_t subrow);
    /// Moves all chains in the list, and drops those that end.
    void move_to(std::int32_t subrow);

    /// Whether there are chains that it has not reached, the first of which begins at next_top().
    bool has_waiting() const { return layer_.waiting != layer_.outlines.end_chain; }
    std::int32_t next_top() const { return top_of(layer_.waiting); }
    std::int32_t top_of(std::uint16_t chain) const { return store_.corner(store_.chain(chain).first).y; }

    OutlineStore& store() const { return store_; }
    Layer& layer() const { return layer_; }
    Chain& chain(std::uint16_t number) const { return store_.chain(number); }

private:
    OutlineStore& store_;
    Layer& layer_;
};

}
