#pragma once

#include "tests/firmware/slots/first_version.hpp"
#include "tests/firmware/slots/padded_scene.hpp"
#include "tests/firmware/slots/pretend_flash.hpp"
#include "tests/firmware/slots/small_places.hpp"
#include "tests/fuzz/input.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace kfast::test {

/// Puts into a flash what the bytes of a fuzzer say: anything at all, scenes, and directories with right
/// checksums whose numbers are anything at all, so that some of it gets past the checks.
class FlashFiller {
public:
    FlashFiller(PretendFlash& flash, FuzzInput& input) : flash_{flash}, input_{input} {}

    void fill()
    {
        while (!input_.at_end()) {
            switch (input_.below(6)) {
            case 1:
                put_bytes();
                break;
            case 2:
                put_scene();
                break;
            case 3:
                put_directory(any_directory());
                break;
            case 4:
                put_sealed_bytes();
                break;
            case 5:
                spoil();
                break;
            default:
                return;
            }
        }
    }

    /// Whether sectors do not hold what they are given.
    bool is_spoiled() const { return is_spoiled_; }
    /// Whether one device may have written all copies of the directory, one after the other: which of them is
    /// the newest does not depend on which others there are.
    bool has_one_history() const
    {
        const std::vector<std::uint32_t> generations = generations_of_copies();
        return std::ranges::all_of(generations, [&](std::uint32_t generation) {
            return std::ranges::all_of(generations, [=](std::uint32_t other) {
                return generation - other < 0x4000'0000 || other - generation < 0x4000'0000;
            });
        });
    }

private:
    static constexpr std::uint32_t sectors = small_flash_bytes / sector_bytes;

    std::vector<std::uint32_t> generations_of_copies() const
    {
        std::vector<std::uint32_t> generations;
        for (std::uint32_t number = 0; number < FlashPlaces::directory_sectors; ++number) {
            const auto bytes = flash_.contents().subspan(small_places.directory_sector(number), sector_bytes);
            if (const auto copy = read_slot_directory(bytes, small_places.former_pool_bytes()))
                generations.push_back(copy->generation);
        }
        return generations;
    }

    void put(std::uint32_t offset, std::span<const std::byte> bytes)
    {
        for (std::uint32_t at = 0; at < bytes.size(); at += page_bytes) {
            std::array<std::byte, page_bytes> page;
            page.fill(std::byte{0xFF});
            std::ranges::copy(bytes.subspan(at, std::min<std::size_t>(page_bytes, bytes.size() - at)),
                              page.begin());
            if (offset + at < small_flash_bytes)
                flash_.program(offset + at, page);
        }
    }

    /// Over what is there: programming makes zeros only.
    void put_bytes()
    {
        const std::uint32_t sector = input_.below(sectors);
        const std::uint32_t page = input_.below(sector_bytes / page_bytes);
        put(sector * sector_bytes + page * page_bytes, input_.take(input_.u8()));
    }

    void put_scene()
    {
        const std::uint32_t seed = input_.u8();
        const std::uint32_t sector = input_.below(pool_sectors + 2);
        put(small_places.pool + sector * sector_bytes, padded_scene(input_.u16() % 0x4000, seed));
    }

    SlotEntry any_entry()
    {
        const bool is_right = input_.flag();
        SlotEntry entry{.name = {"any"}};
        entry.offset = input_.below(pool_sectors + 3) * sector_bytes;
        entry.size = input_.u16();
        if (is_right && entry.size <= small_flash_bytes - small_places.pool - entry.offset)
            entry.crc = crc_of(flash_.contents().subspan(small_places.pool + entry.offset, entry.size));
        else
            entry.crc = input_.u32();
        return entry;
    }

    SlotDirectory any_directory()
    {
        SlotDirectory directory;
        directory.generation = input_.flag() ? input_.u32() : input_.u8();
        directory.next = input_.below(pool_sectors + 4) * sector_bytes;
        const std::uint8_t chosen = input_.below(SlotDirectory::slot_count + 2);
        directory.chosen = chosen > SlotDirectory::slot_count ? SlotDirectory::none : chosen;
        directory.bad_copies = input_.flag() ? input_.u8() : std::uint8_t{0};
        is_spoiled_ = is_spoiled_ || directory.bad_copies != 0;
        directory.bad_sectors.bits[0] = std::byte{input_.u8()};
        directory.bad_sectors.bits[1] = std::byte{input_.u8()};
        for (SlotEntry& entry : std::span{directory.slots}.first(input_.below(SlotDirectory::slot_count + 1)))
            entry = any_entry();
        return directory;
    }

    void put_directory(const SlotDirectory& directory)
    {
        const bool is_first_version = input_.flag();
        const std::uint32_t offset = small_places.directory_sector(input_.below(4));
        flash_.erase(offset);
        put(offset, is_first_version ? first_version_of(directory) : slot_directory_pages_of(directory));
    }

    /// A directory whose fields are the bytes as they are.
    void put_sealed_bytes()
    {
        constexpr std::size_t fields = 8;
        SlotDirectoryPages pages = slot_directory_pages_of({});
        const auto body = std::span{pages}.first(slot_directory_bytes - 4).subspan(fields);
        std::ranges::fill(body, std::byte{0});
        const std::uint32_t offset = small_places.directory_sector(input_.below(4));
        std::ranges::copy(input_.take(body.size()), body.begin());
        const std::uint32_t crc = crc_of(std::span{pages}.first(slot_directory_bytes - 4));
        for (std::size_t byte = 0; byte < 4; ++byte)
            pages[slot_directory_bytes - 4 + byte] = static_cast<std::byte>(crc >> 8 * byte & 255);
        is_spoiled_ = true; // who knows
        flash_.erase(offset);
        put(offset, pages);
    }

    void spoil()
    {
        const std::uint32_t sector = 1 + input_.below(sectors - 2);
        flash_.spoil(sector * sector_bytes, every_fault[input_.below(every_fault.size())]);
        is_spoiled_ = true;
    }

    PretendFlash& flash_;
    FuzzInput& input_;
    bool is_spoiled_ = false;
};

}
