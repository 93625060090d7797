#pragma once

#include "core/bytes/expects.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// What pictures are made from and need not be made anew for each of them: sets of words by name, in memory
/// that the caller lends. What finds no room is not kept; made again, it is the same.
///
///     | name, size | words | name, size | words | ...  free |
///
/// Sets are looked for from the one that was found last on, for pictures want them in the same order.
class PictureCache {
public:
    using Name = std::array<std::uint32_t, 3>;

    PictureCache() = default;
    /// `memory` is aligned to 4 bytes.
    explicit PictureCache(std::span<std::byte> memory)
        : memory_{reinterpret_cast<std::uint32_t*>(memory.data())}, size_{memory.size() / 4}
    {
        expects(reinterpret_cast<std::uintptr_t>(memory.data()) % 4 == 0);
    }

    void begin_picture();

    /// The words of a set, which is of use for this picture; valid until another set is begun. Returns null
    /// if it is not kept.
    const std::uint32_t* find(const Name& name);
    /// The number of words of the set that was found or completed last.
    std::size_t count() const { return set_at(found_).words - head_words; }

    /// An incoming set replaces sets that neither this picture nor the one before has wanted; then, if it
    /// replaces the next, those of its kind (the last word of names) that come next and that this picture has
    /// not wanted so far. A set that found no room in that way replaces none when it is added again.
    enum class Incoming : std::uint8_t { beside_others, replaces_next };

    /// Begins a set. None of this name is kept yet.
    [[gnu::cold, gnu::noinline]] void begin(const Name& name, Incoming incoming);
    /// Adds memory for `count` more words; valid until the next call. Returns null if they find no room, then
    /// the set is not kept.
    [[gnu::cold, gnu::noinline]] std::uint32_t* add(std::size_t count);
    /// All of its words so far; valid until the next call.
    std::uint32_t* incoming() const { return words_of(used_); }
    /// Ends the set. Returns its words, if it is complete and found room; then it is kept.
    [[gnu::cold, gnu::noinline]] const std::uint32_t* end(bool is_complete);

    /// The size of the sets that were of use in this picture.
    std::size_t bytes_in_use() const;

private:
    struct Set {
        Name name;
        std::uint32_t words : 24;  ///< with these
        std::uint32_t picture : 8; ///< the last one that it was of use in
    };

    static constexpr std::size_t head_words = sizeof(Set) / 4;
    static constexpr std::size_t max_words = (1U << 24) - 1;
    static constexpr std::uint32_t max_picture = 255;

    Set& set_at(std::size_t place) const { return *reinterpret_cast<Set*>(memory_ + place); }
    std::uint32_t* words_of(std::size_t place) const { return memory_ + place + head_words; }
    std::size_t next_place(std::size_t place) const;
    [[gnu::cold]] bool reserve(std::size_t count);
    [[gnu::cold]] bool remove_one();
    [[gnu::cold]] void remove(std::size_t place);

    std::uint32_t* memory_ = nullptr;
    std::size_t size_ = 0;     ///< of the memory, in words, as all that follows
    std::size_t used_ = 0;     ///< by sets that are kept
    std::size_t end_ = 0;      ///< of the incoming set
    std::size_t found_ = 0;    ///< offset of the set that was found last
    bool is_incoming_ = false; ///< whether a set is being added, and has found room so far
    Incoming incoming_ = Incoming::beside_others;
    Name name_{};              ///< of the incoming set
    Name failed_{};            ///< of the last one that found no room
    std::uint8_t picture_ = 2; ///< a number of it; sets of older ones may have 0
};

}
