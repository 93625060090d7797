#include "host/flash/uf2_contents.hpp"

#include "host/flash/flash_image.hpp"
#include "host/flash/uf2.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace kfast {
namespace {

constexpr std::uint64_t end_of_addresses = std::uint64_t{1} << 32;
constexpr std::uint32_t rp2040_flash = 0x1000'0000;
constexpr std::uint32_t rp2040_memory = 0x2000'0000; ///< after the addresses of flash
constexpr std::uint32_t rp2040_end = 0x2004'2000;

/// picotool puts a block before files for the RP2350, because of its erratum E10, that is not to be
/// written, and says that it is one of two (raspberrypi/picotool, elf2uf2/elf2uf2.cpp, check_abs_block()).
bool is_left_out(const Uf2Block& block)
{
    constexpr std::uint32_t absolute_family = 0xE48B'FF57;
    constexpr std::uint32_t extension_tags = 0x8000;
    return (block.flags & ~extension_tags) == Uf2Block::names_family && block.family == absolute_family &&
           block.number == 0 && block.count == 2 && block.payload_bytes == Uf2Block::payload_size &&
           std::ranges::all_of(block.payload, [](std::byte byte) { return byte == std::byte{0xEF}; });
}

/// What a block writes.
struct Piece {
    std::uint32_t address = 0;
    std::size_t block = 0;
    std::span<const std::byte> bytes;

    std::uint64_t end() const { return std::uint64_t{address} + bytes.size(); }
};

struct Family {
    Uf2Part part;
    std::uint32_t next = 0;                      ///< the number that the next block should have
    std::optional<std::uint32_t> declared_count; ///< of its blocks, as given in them
    std::vector<Piece> pieces;
};

class Reader {
public:
    explicit Reader(std::span<const std::byte> file) : file_{file} {}

    Uf2Contents contents()
    {
        for (; block_ < file_.size() / Uf2Block::bytes; ++block_)
            read_block(file_.subspan(block_ * Uf2Block::bytes).first<Uf2Block::bytes>());
        expect_whole_blocks();
        for (Family& family : families_)
            finish(family);
        std::ranges::stable_sort(mistakes_, {}, &Uf2Mistake::block);
        return {block_, std::move(parts_), std::move(mistakes_)};
    }

private:
    bool expect(bool is_valid, const std::string& reason)
    {
        if (!is_valid)
            mistakes_.push_back({block_, reason});
        return is_valid;
    }

    void expect_whole_blocks()
    {
        const std::size_t rest = file_.size() % Uf2Block::bytes;
        expect(rest == 0, "the file ends after " + std::to_string(rest) +
                              " of its 512 bytes: it was cut off, or is no UF2 file");
        expect(!file_.empty(), "the file is empty");
        expect(!families_.empty() || !mistakes_.empty(), "there is nothing to be written");
    }

    void read_block(std::span<const std::byte, Uf2Block::bytes> bytes)
    {
        const auto block = read_uf2_block(bytes);
        if (!expect(block.has_value(), "it does not begin and end as a block of a UF2 file"))
            return count_unreadable();
        if (is_left_out(*block))
            return;
        Family& family = family_of(*block);
        ++family.part.blocks;
        family.part.flags |= block->flags;
        expect_number(*block, family);
        const bool is_for_rp2040 = family.part.family == rp2040_family;
        if (is_written(block->flags, is_for_rp2040) && has_payload(*block, is_for_rp2040) &&
            has_place(*block, is_for_rp2040))
            family.pieces.push_back({block->address, block_, block->payload});
    }

    /// It counts as one of the family before it, so that the others keep their numbers.
    void count_unreadable()
    {
        if (families_.empty()) {
            ++unreadable_first_;
            return;
        }
        ++families_[current_].part.blocks;
        ++families_[current_].next;
    }

    Family& family_of(const Uf2Block& block)
    {
        const bool is_named = (block.flags & Uf2Block::names_family) != 0;
        const auto id = is_named ? std::optional{block.family} : std::nullopt;
        const auto [place, is_new] = places_.try_emplace(id, families_.size());
        current_ = place->second;
        if (is_new) {
            const std::uint32_t before = std::exchange(unreadable_first_, 0);
            families_.push_back({{id, block_, before, 0, {}}, before, {}, {}});
        }
        return families_[current_];
    }

    void expect_number(const Uf2Block& block, Family& family)
    {
        expect(block.number == family.next, "it calls itself block " + std::to_string(block.number) +
                                                " where block " + std::to_string(family.next) +
                                                " should come");
        family.next = block.number + 1;
        const std::uint32_t before = family.declared_count.value_or(block.count);
        expect(block.count == before, "it says that there are " + std::to_string(block.count) +
                                          " blocks, but those before it said " + std::to_string(before));
        family.declared_count = block.count;
    }

    bool is_written(std::uint32_t flags, bool is_for_rp2040)
    {
        if (!expect((flags & Uf2Block::holds_files) == 0, "it is part of a stored file"))
            return false;
        const bool is_for_flash = (flags & Uf2Block::not_for_flash) == 0;
        expect(is_for_flash || !is_for_rp2040, "it is not for flash, so that an RP2040 leaves it out");
        return is_for_flash;
    }

    bool has_payload(const Uf2Block& block, bool is_for_rp2040)
    {
        const std::string carries = "it carries " + std::to_string(block.payload_bytes) + " bytes";
        if (is_for_rp2040)
            return expect(block.payload_bytes == Uf2Block::payload_size,
                          carries + " where an RP2040 takes 256 alone");
        return expect(block.payload_bytes > 0 && block.payload_bytes <= Uf2Block::payload_room,
                      carries + " where there is room for 1 to 476");
    }

    bool has_place(const Uf2Block& block, bool is_for_rp2040)
    {
        const std::uint64_t end = std::uint64_t{block.address} + block.payload.size();
        const std::string address = "its address " + hex_text(block.address);
        if (!is_for_rp2040)
            return expect(block.address % 4 == 0, address + " is no multiple of 4") &&
                   expect(end <= end_of_addresses, address + " is too near to the last one of 32 bits");
        const bool is_memory = block.address >= rp2040_memory;
        return expect(block.address >= rp2040_flash && end <= rp2040_end &&
                          (is_memory || end <= rp2040_memory),
                      address + " is neither in flash nor in RAM of an RP2040") &&
               expect(is_memory || block.address % Uf2Block::payload_size == 0,
                      address + " is no multiple of 256");
    }

    void finish(Family& family)
    {
        Uf2Part& part = family.part;
        const std::uint32_t declared = family.declared_count.value_or(0);
        if (declared != part.blocks)
            mistakes_.push_back({part.first_block, "it says that there are " + std::to_string(declared) +
                                                       " blocks for its chips, but there are " +
                                                       std::to_string(part.blocks)});
        join(family);
        parts_.push_back(std::move(part));
    }

    void join(Family& family)
    {
        std::ranges::sort(family.pieces, {}, [](const Piece& piece) {
            return std::tuple{piece.address, piece.block};
        });
        auto& regions = family.part.regions;
        const Piece* before = nullptr;
        for (const Piece& piece : family.pieces) {
            if (before != nullptr && piece.address < before->end()) {
                const auto [first, second] = std::minmax(before->block, piece.block);
                mistakes_.push_back({second, "it writes to " + hex_text(piece.address) + ", as block " +
                                                 std::to_string(first) + " has done before"});
                continue;
            }
            if (before == nullptr || before->end() != piece.address)
                regions.push_back({piece.address, {}});
            regions.back().bytes.insert(regions.back().bytes.end(), piece.bytes.begin(), piece.bytes.end());
            before = &piece;
        }
    }

    std::span<const std::byte> file_;
    std::size_t block_ = 0; ///< the one that is being read
    std::vector<Family> families_;
    std::map<std::optional<std::uint32_t>, std::size_t> places_; ///< of families by their numbers
    std::size_t current_ = 0;                                    ///< the family of the block before
    std::uint32_t unreadable_first_ = 0;                         ///< blocks before the first family
    std::vector<Uf2Part> parts_;
    std::vector<Uf2Mistake> mistakes_;
};

}

Uf2Contents read_uf2(std::span<const std::byte> file) { return Reader{file}.contents(); }

}
