#pragma once

#include "core/bytes/expects.hpp"
#include "core/bytes/op_counter.hpp"
#include "core/math/point.hpp"
#include "core/raster/outline/chain.hpp"
#include "core/raster/outline/contour_cache.hpp"
#include "core/raster/outline/grid.hpp"
#include "core/raster/outline/paint_step.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// The outlines of one picture as chains, layer by layer, in memory that the caller lends.
///
///     | corners of the contour coming in >  free  < those added behind | chain | chain | layer | chain | ...
///                                                                        ^ the last one
///
/// A layer whose outlines stay as they are from picture to picture can be kept: keep() is called in place of
/// clear(), and reuse() in place of tracing it.
class OutlineStore {
public:
    OutlineStore() = default;
    /// `storage` is aligned to 4 bytes, its size is a multiple of 4. `heads` has a word for each band of
    /// 2^band_bits rows, or more of them. Sides of the panel are at most 4096 px long.
    OutlineStore(std::span<std::byte> storage, std::span<std::uint32_t> heads, Size panel, int band_bits);

    /// Forgets all outlines.
    void clear();
    /// Keeps those layers that do not depend on what has moved since the last picture. None of them is in the
    /// next one unless it is reused.
    void keep(const Dependence& moved);
    /// Takes a layer into the picture, painted by a step. Returns null if it is not kept, or not found:
    /// layers are looked for in the order in which they were traced. Whether the picture is full does not
    /// depend on what was kept.
    const LayerOutlines* reuse(LayerName name, std::uint16_t step);
    /// Whether reuse() would find it.
    bool keeps(LayerName name) const { return kept_layer(name) != nullptr; }
    /// All contours belong to a layer: they are added between begin_layer() and end_layer().
    void begin_layer(LayerName name, std::uint16_t step);
    /// `dependence`: what moves them. Returns null if something found no room.
    const LayerOutlines* end_layer(const Dependence& dependence);

    /// A contour comes from both of its ends at once: its corners in order are those that were added, then
    /// those that were added behind, the last of these first. So both sides of a line can be drawn as it is
    /// followed. Nothing else is added before close().
    void add(Corner corner)
    {
        count_op(Op::corner);
        if (corners_end_ + 1 > behind_)
            is_full_ = true;
        else
            *corners_end_++ = corner;
    }
    void add_behind(Corner corner);
    /// Joins the last corner to the first.
    void close();
    /// From now on, contours are placed by `map` when they are closed, and before that simplified and kept in
    /// `cache`, if there is one. Their name, if they have one, represents their corners in the fingerprint.
    void place_contours(const CornerMap& map, const ContourName* name, ContourCache* cache);
    /// Adds a contour that was kept.
    void add(const KeptContour& contour);
    /// From now on, contours are added where they are.
    void end_placed();

    /// Puts all chains back into the state in which a picture is drawn from its first band on, of 2^band_bits
    /// rows: to draw it changes them.
    void rewind(int band_bits);

    /// Whether something found no room: the picture is not complete.
    bool is_full() const { return is_full_; }
    /// Whether layers of the last picture take room: if they were traced anew, the picture might fit.
    bool keeps_layers() const { return kept_end_ != bytes_ + size_; }
    /// The maximum that would have been needed at a time if nothing had been kept.
    std::size_t needed_bytes() const { return needed_; }

    /// The first chain that begins in a band; Chain::none if there is none.
    std::uint32_t first_in(int band) const
    {
        expects(band >= 0 && static_cast<std::size_t>(band) < heads_.size());
        return heads_[static_cast<std::size_t>(band)];
    }
    /// `place` is not Chain::none.
    Chain& chain(std::uint32_t place) const
    {
        expects(place != Chain::none && place < size_);
        return *reinterpret_cast<Chain*>(bytes_ + place);
    }
    const Crossing* crossing(std::uint32_t place) const
    {
        return reinterpret_cast<const Crossing*>(bytes_ + place);
    }
    const Bend* bend(std::uint32_t place) const { return reinterpret_cast<const Bend*>(bytes_ + place); }
    /// The line of a chain that is straight.
    StraightLine& line(const Chain& chain) const
    {
        expects(chain.is_straight);
        return *reinterpret_cast<StraightLine*>(bytes_ + chain.crossings - offsetof(StraightLine, in_band));
    }
    /// Calls visit(chain) for each chain of the picture.
    template <class Visit>
    void each_chain(Visit visit) const
    {
        each_layer([&](LayerOutlines& layer) {
            if (layer.step != LayerOutlines::no_step)
                each_chain_of(layer, visit);
        });
    }
    /// The size of a chain.
    static std::size_t chain_bytes(const Chain& chain) { return 4U * chain.words; }

    int band_bits() const { return band_bits_; }

private:
    /// How many layers may have vanished at one position before others are taken to be new.
    static constexpr int look_ahead = 8;

    /// Calls visit(layer) for each of them, also those that are kept, but not in the picture.
    template <class Visit>
    void each_layer(Visit visit) const
    {
        for (std::byte* end = bytes_ + size_; end != chains_;) {
            LayerOutlines& layer = layer_below(end);
            end -= bytes_of(layer);
            visit(layer);
        }
    }
    template <class Visit>
    static void each_chain_of(LayerOutlines& layer, Visit visit)
    {
        auto* const end = reinterpret_cast<std::byte*>(&layer);
        for (std::byte* at = end - layer.bytes; at != end;) {
            auto& chain = *reinterpret_cast<Chain*>(at);
            at += chain_bytes(chain);
            visit(chain);
        }
    }
    static LayerOutlines& layer_below(std::byte* end) { return *(reinterpret_cast<LayerOutlines*>(end) - 1); }
    /// The size of a layer with its chains.
    static std::size_t bytes_of(const LayerOutlines& layer) { return sizeof(LayerOutlines) + layer.bytes; }
    LayerOutlines* kept_layer(LayerName name) const;
    void begin_picture();
    void begin_contour();
    bool reserve(std::size_t bytes);
    void place_corners();
    void add_contour();
    Corner* first_corner() const { return reinterpret_cast<Corner*>(bytes_); }
    Corner* first_turn() const;
    bool add_runs(bool is_near);
    bool find_runs(Corner* first, Corner* last, bool frees_corners);
    Corner* begin_of_run(Corner* first, Corner* end) const;
    bool add_run(Corner* first, Corner* last, bool runs_down);
    bool add_cut(Corner* top, Corner* bottom, std::ptrdiff_t step);
    bool add_chain(const Corner* top, const Corner* bottom, std::ptrdiff_t step);
    bool add_straight(Corner top, Corner bottom, std::int32_t left, bool runs_down);
    Chain& put_chain(std::byte* end, Corner top, Corner bottom, std::int32_t left, bool runs_down);
    void rewind(Chain& chain);
    void end_chains_at(std::byte* chains);
    void remove_chains(std::byte* mark);
    std::uint32_t place_of(const void* at) const
    {
        return static_cast<std::uint32_t>(static_cast<const std::byte*>(at) - bytes_);
    }

    std::byte* bytes_ = nullptr;
    Corner* corners_end_ = nullptr; ///< of the incoming contour
    Corner* behind_ = nullptr;      ///< the last one that was added behind
    std::byte* chains_ = nullptr;   ///< the last one that was added
    LayerOutlines* layer_ = nullptr;
    std::byte* kept_ = nullptr;      ///< the end of the layer that may come next
    std::byte* kept_end_ = nullptr;  ///< the lower end of all that were kept
    std::size_t waiting_ = 0;        ///< bytes of layers that were kept and have not been reused
    const CornerMap* map_ = nullptr; ///< places contours; null if they are added as they are seen
    ContourCache* cache_ = nullptr;  ///< keeps contours before they are placed
    bool is_named_ = false;          ///< the fingerprint has the name of the incoming contours
    std::span<std::uint32_t> heads_;
    std::size_t size_ = 0;
    std::size_t needed_ = 0;
    Size panel_;
    int band_bits_ = 0;
    bool is_large_ = false; ///< whether the panel is large: x of a chain counts from a column of its own
    bool is_full_ = false;
};

}
