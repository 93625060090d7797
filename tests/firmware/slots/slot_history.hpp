#pragma once

#include "tests/firmware/slots/slot_bench.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace kfast::test {

/// A scene of a history, one of a few.
struct HistoryScene {
    Scene bytes;
    std::uint32_t crc = 0;
};

inline const std::vector<HistoryScene>& history_scenes()
{
    static const std::vector<HistoryScene> scenes = [] {
        std::vector<HistoryScene> made;
        for (std::uint32_t seed = 0; seed < 24; ++seed) {
            const std::size_t sectors = seed % 12 == 0 ? 2 : seed % 4 == 1 ? 1 : 0;
            const Scene scene = padded_scene(300 + sectors * sector_bytes + 30 * seed, seed);
            made.push_back({scene, crc_of(scene)});
        }
        return made;
    }();
    return scenes;
}

/// What the slots are to hold: numbers of scenes, names of one letter.
struct HistoryState {
    static constexpr int empty = -1;
    struct Slot {
        int scene = empty;
        char name = 0;
        friend bool operator==(const Slot&, const Slot&) = default;
    };
    std::array<Slot, SlotDirectory::slot_count> slots{};
    std::optional<std::uint8_t> chosen;
    friend bool operator==(const HistoryState&, const HistoryState&) = default;

    bool is_in(const Store& store) const
    {
        for (std::uint8_t slot = 0; slot < SlotDirectory::slot_count; ++slot) {
            const Slot& expected = slots[slot];
            const bool is_empty = expected.scene == empty;
            if (store.entry(slot).is_empty() != is_empty)
                return false;
            if (!is_empty && (store.entry(slot).name.view() != std::string_view{&expected.name, 1} ||
                              !std::ranges::equal(store.scene(slot), scene(expected).bytes)))
                return false;
        }
        return store.chosen() == chosen;
    }
    static const HistoryScene& scene(const Slot& slot)
    {
        return history_scenes()[static_cast<std::size_t>(slot.scene)];
    }
};

/// Random changes of slots, with restarts, power cuts and sectors that turn bad between and in them.
class SlotHistory {
public:
    /// With `is_fickle` what a cut leaves may be read differently at each start; then no more than one sector
    /// of the directory is bad, else two.
    SlotHistory(std::uint32_t seed, bool is_fickle) : random_{seed}, is_fickle_{is_fickle}
    {
        static const std::array remains{remains_of(1), remains_of(2), remains_of(3)};
        if (const std::uint32_t which = below(4); which < remains.size())
            flash_ = remains[which];
        for (std::uint32_t count = below(4); count > 0; --count)
            spoil_a_sector();
        store_.emplace(flash_, small_places);
    }

    void change()
    {
        if (below(5) == 0)
            spoil_a_sector();
        if (below(3) == 0)
            restart();
        if (below(2) == 0)
            cut();
        make(any_change());
        flash_.power_again();
    }

    std::uint64_t cuts() const { return cuts_; }
    std::uint64_t bad_sectors() const { return bad_.size(); }

    /// A sector is not used again once it was found to be bad. A cut may come between that and noting it.
    void expect_bad_sectors_at_rest() const
    {
        for (const Bad& sector : bad_)
            REQUIRE(times_erased(sector.offset) - sector.before <= 1 + cuts_);
    }

private:
    struct Change {
        enum class Kind { upload, erase, choose };
        Kind kind = Kind::upload;
        std::uint8_t slot = 0;
        HistoryState::Slot contents;
    };
    struct Bad {
        std::uint32_t offset = 0;
        std::uint64_t before = 0; ///< how often it was erased while it was good
    };

    static PretendFlash remains_of(std::uint32_t seed)
    {
        PretendFlash flash{small_flash_bytes};
        flash.fill_with(seed);
        return flash;
    }
    std::uint32_t below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
    std::uint64_t times_erased(std::uint32_t offset) const
    {
        return static_cast<std::uint64_t>(flash_.erased_sectors()[offset / sector_bytes]);
    }

    void spoil_a_sector()
    {
        const bool is_of_directory = bad_copies_ < (is_fickle_ ? 1U : 2U) && below(3) == 0;
        if (!is_of_directory && bad_.size() >= 5)
            return;
        const std::uint32_t offset =
            is_of_directory ? small_places.directory_sector(below(FlashPlaces::directory_sectors))
                            : small_places.pool + below(pool_sectors) * sector_bytes;
        if (flash_.is_bad(offset))
            return;
        const Fault fault = every_fault[below(every_fault.size())];
        flash_.spoil(offset, fault);
        bad_copies_ += is_of_directory ? 1 : 0;
        // Where there is nothing to erase, one that cannot be erased holds.
        if (fault != Fault::erase_error && fault != Fault::erase_does_nothing)
            bad_.push_back({offset, times_erased(offset)});
    }

    /// A start finds one of the states that are possible.
    void restart()
    {
        flash_.power_again();
        store_.emplace(flash_, small_places);
        const auto found =
            std::ranges::find_if(possible_, [&](const HistoryState& state) { return state.is_in(*store_); });
        REQUIRE(found != possible_.end());
        now_ = *found;
        if (!is_fickle_)
            possible_ = {now_};
    }

    void cut()
    {
        const Remains remains = is_fickle_ ? Remains::fickle : static_cast<Remains>(below(4));
        flash_.cut(static_cast<int>(below(below(2) == 0 ? 16 : 60)), remains,
                   static_cast<std::uint32_t>(random_()));
    }

    Change any_change()
    {
        const auto slot = static_cast<std::uint8_t>(below(SlotDirectory::slot_count));
        const auto scene = static_cast<int>(below(static_cast<std::uint32_t>(history_scenes().size())));
        const std::uint32_t what = below(6);
        const Change::Kind kind = what < 4    ? Change::Kind::upload
                                  : what == 4 ? Change::Kind::erase
                                              : Change::Kind::choose;
        return {kind, slot, {scene, static_cast<char>('a' + below(26))}};
    }

    HistoryState changed(const Change& change) const
    {
        HistoryState state = now_;
        HistoryState::Slot& slot = state.slots[change.slot];
        if (change.kind == Change::Kind::upload)
            slot = change.contents;
        else if (change.kind == Change::Kind::choose)
            state.chosen = change.slot;
        else
            slot = {};
        if (change.kind == Change::Kind::erase && state.chosen == change.slot)
            state.chosen.reset();
        return state;
    }

    void make(const Change& change)
    {
        const auto held = store_->scene(static_cast<std::uint8_t>(below(SlotDirectory::slot_count)));
        const Scene before{held.begin(), held.end()};
        try {
            settle(change, attempt(change, held));
            REQUIRE(std::ranges::equal(held, before));
            REQUIRE(now_.is_in(*store_));
        } catch (const PowerCut&) {
            ++cuts_;
            possible_.push_back(changed(change));
            restart();
        }
    }

    Status attempt(const Change& change, std::span<const std::byte> held)
    {
        if (change.kind == Change::Kind::erase)
            return store_->erase(change.slot);
        if (change.kind == Change::Kind::choose)
            return store_->choose(change.slot);
        // It may have moved to where there was no room besides what it had to move.
        Status status = Status::flash_failed;
        for (int tries = 0; status == Status::flash_failed && tries < 8; ++tries)
            status = upload(change, held);
        if (status == Status::no_room)
            REQUIRE(store_->longest_room(held) < HistoryState::scene(change.contents).bytes.size());
        return status;
    }
    Status upload(const Change& change, std::span<const std::byte> held)
    {
        const HistoryScene& scene = HistoryState::scene(change.contents);
        const SlotUpload what{change.slot,
                              static_cast<std::uint32_t>(scene.bytes.size()),
                              scene.crc,
                              {std::string_view{&change.contents.name, 1}}};
        if (const StatusWithNumber begun = store_->begin(what, held); !begun.is_ok())
            return begun.status;
        store_->write(scene.bytes);
        return store_->finish();
    }

    void settle(const Change& change, Status status)
    {
        const bool is_empty = now_.slots[change.slot].scene == HistoryState::empty;
        if (change.kind == Change::Kind::upload)
            REQUIRE((status == Status::ok || status == Status::no_room));
        else
            REQUIRE(status == (is_empty ? Status::empty_slot : Status::ok));
        if (status != Status::ok)
            return;
        now_ = changed(change);
        possible_ = {now_};
    }

    std::mt19937 random_;
    bool is_fickle_;
    PretendFlash flash_{small_flash_bytes};
    std::optional<Store> store_;
    HistoryState now_; ///< what the store shows
    std::vector<HistoryState> possible_{HistoryState{}};
    std::vector<Bad> bad_;
    std::uint32_t bad_copies_ = 0;
    std::uint64_t cuts_ = 0;
};

}
