#pragma once

#include "core/raster/chain.hpp"
#include "core/raster/fingerprint.hpp"
#include "core/raster/grid.hpp"
#include "core/size.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::raster {

/// The outlines of one picture as chains, in memory that the caller lends.
///
///     | corners of the contour that is coming in >  free  < those added behind | chain | chain | ... |
///                                                                                ^ the last one
class OutlineStore {
public:
    OutlineStore() = default;
    /// `storage` is aligned to 4 bytes, its size is a multiple of 4. `heads` has a word for each band of
    /// 2^band_bits rows, or more of them. Sides of the panel are at most 4096 px long.
    OutlineStore(std::span<std::byte> storage, std::span<std::uint32_t> heads, Size panel, int band_bits);

    /// Forgets all outlines.
    void clear();
    /// Contours belong to this layer from now on.
    void begin_layer(std::uint16_t layer)
    {
        layer_ = layer;
        fingerprint_ = {};
    }
    /// Of the contours of the layer that were closed.
    Fingerprint fingerprint() const { return fingerprint_; }

    /// A contour comes from both of its ends at once: its corners in order are those that were added, then
    /// those that were added behind, the last of these first. So both sides of a line can be drawn as it is
    /// followed. Nothing else is added before close().
    void add(Corner corner);
    void add_behind(Corner corner);
    /// Joins the last corner to the first.
    void close();

    /// Puts all chains back into the state in which a picture is drawn from its first band on, of 2^band_bits
    /// rows: to draw it changes them.
    void rewind(int band_bits);

    /// Something found no room: the picture is not complete.
    bool is_full() const { return is_full_; }
    /// The most that was needed at a time since clear().
    std::size_t needed_bytes() const { return needed_; }

    /// The first chain that begins in a band; Chain::none if there is none.
    std::uint32_t first_in(int band) const { return heads_[static_cast<std::size_t>(band)]; }
    Chain& chain(std::uint32_t place) const { return *reinterpret_cast<Chain*>(bytes_ + place); }
    const Crossing* crossing(std::uint32_t place) const
    {
        return reinterpret_cast<const Crossing*>(bytes_ + place);
    }
    const Bend* bend(std::uint32_t place) const { return reinterpret_cast<const Bend*>(bytes_ + place); }
    const StraightLine& line(const Chain& chain) const
    {
        return *reinterpret_cast<const StraightLine*>(bytes_ + chain.crossings);
    }
    /// Calls visit(chain) for each of them.
    template <class Visit>
    void each_chain(Visit visit) const
    {
        for (const std::byte* at = chains_; at != bytes_ + size_;) {
            const auto& chain = *reinterpret_cast<const Chain*>(at);
            at += chain_bytes(chain);
            visit(chain);
        }
    }
    /// What a chain takes.
    static std::size_t chain_bytes(const Chain& chain) { return 4U * chain.words; }

    int band_bits() const { return band_bits_; }

private:
    void begin_contour();
    bool find_room(std::size_t bytes);
    Corner* first_corner() const { return reinterpret_cast<Corner*>(bytes_); }
    Corner* first_turn() const;
    bool add_runs();
    bool find_runs(Corner* run, Corner* last);
    bool add_run(Corner* first, Corner* last, bool runs_down);
    bool add_cut(Corner* top, Corner* bottom, std::ptrdiff_t step);
    bool add_chain(const Corner* top, const Corner* bottom, std::ptrdiff_t step);
    bool add_straight(Corner top, Corner bottom, std::int32_t left, bool runs_down);
    Chain& put_chain(std::byte* bends, Corner top, Corner bottom, std::int32_t left, bool runs_down);
    void rewind(Chain& chain);
    void remove_chains(std::byte* mark);
    std::uint32_t place_of(const void* at) const
    {
        return static_cast<std::uint32_t>(static_cast<const std::byte*>(at) - bytes_);
    }

    std::byte* bytes_ = nullptr;
    Corner* corners_end_ = nullptr; ///< of the contour that is coming in
    Corner* behind_ = nullptr;      ///< the last one that was added behind
    std::byte* chains_ = nullptr;   ///< the last one that was added
    std::span<std::uint32_t> heads_;
    std::size_t size_ = 0;
    std::size_t needed_ = 0;
    Size panel_;
    int band_bits_ = 0;
    std::uint16_t layer_ = 0;
    Fingerprint fingerprint_;
    bool is_large_ = false; ///< the panel: chains are counted from columns of their own
    bool is_full_ = false;
};

}
