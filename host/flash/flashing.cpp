#include "host/flash/flashing.hpp"

#include "host/flash/flash_image.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>
#include <string>

namespace kfast {
namespace {

using Sector = FlashImage::Sector;
using Bytes = decltype(Sector::bytes);

constexpr std::byte erased{0xFF};

std::string in_words(std::byte byte)
{
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "0x%02x", std::to_integer<unsigned>(byte));
    return text.data();
}

Bytes read_sector(BootLoader& boot_loader, std::uint32_t address)
{
    Bytes bytes{};
    boot_loader.read(address, bytes);
    return bytes;
}

/// Throws Failure with not_verified, whose text ends with `hint`.
void require_sector(BootLoader& boot_loader, const Sector& expected, const char* hint)
{
    const Bytes found = read_sector(boot_loader, expected.address);
    const auto [wanted, there] = std::ranges::mismatch(expected.bytes, found);
    if (wanted == expected.bytes.end())
        return;
    const auto address =
        expected.address + static_cast<std::uint32_t>(std::distance(expected.bytes.begin(), wanted));
    throw Failure{"flash is not what it should be at " + hex_text(address) + ": expected " +
                      in_words(*wanted) + ", found " + in_words(*there) + ": " + hint,
                  ExitStatus::not_verified};
}

constexpr const char* not_written =
    "flash it again; if that does not help, its flash is worn out, or smaller than what was written";
constexpr const char* another = "the board holds something else, or was not flashed to the end: flash it";

void write_sector(BootLoader& boot_loader, const Sector& sector)
{
    boot_loader.erase(sector.address, sector.bytes.size());
    boot_loader.write(sector.address, sector.bytes);
}

/// Writes in the order in which a board starts nothing if it is interrupted.
class Writing {
public:
    Writing(BootLoader& boot_loader, const FlashImage& image, const std::vector<std::size_t>& sectors,
            const FlashProgressCallback& on_progress)
        : boot_loader_{boot_loader}, first_{image.sectors().front()}, on_progress_{on_progress}
    {
        for (const std::size_t index : sectors)
            if (index != 0)
                others_.push_back(&image.sectors()[index]);
    }

    void run()
    {
        begin(FlashPhase::writing, 0);
        erase_first();
        for (std::size_t done = 0; done < others_.size(); ++done) {
            begin(FlashPhase::writing, done + 1);
            write_sector(boot_loader_, *others_[done]);
        }
        on_progress_(FlashPhase::writing, total(), total());
        for (std::size_t done = 0; done < others_.size(); ++done) {
            begin(FlashPhase::verifying, done);
            require_sector(boot_loader_, *others_[done], not_written);
        }
        begin(FlashPhase::verifying, others_.size());
        write_first();
        on_progress_(FlashPhase::verifying, total(), total());
    }

private:
    std::size_t total() const { return others_.size() + 1; }

    void begin(FlashPhase phase, std::size_t done)
    {
        on_progress_(phase, done, total());
        heed_interruption();
    }

    void erase_first() { boot_loader_.erase(first_.address, first_.bytes.size()); }

    /// Two addresses that are one in a flash that is too small show here, before the first sector hides it.
    void require_first_erased()
    {
        Sector blank{first_.address, {}};
        blank.bytes.fill(erased);
        require_sector(boot_loader_, blank, not_written);
    }

    /// Its first page comes last: once a board has that, it starts.
    void write_first()
    {
        require_first_erased();
        const std::span bytes{first_.bytes};
        constexpr std::size_t page = FlashImage::page_bytes;
        boot_loader_.write(first_.address + page, bytes.subspan(page));
        boot_loader_.write(first_.address, bytes.first(page));
        try {
            require_sector(boot_loader_, first_, not_written);
        } catch (const Failure&) {
            erase_first();
            throw;
        }
    }

    BootLoader& boot_loader_;
    const Sector& first_;
    std::vector<const Sector*> others_;
    const FlashProgressCallback& on_progress_;
};

}

std::vector<std::size_t> differing_sectors(BootLoader& boot_loader, const FlashImage& image,
                                           const FlashProgressCallback& on_progress)
{
    const auto sectors = image.sectors();
    std::vector<std::size_t> differing;
    for (std::size_t index = 0; index < sectors.size(); ++index) {
        on_progress(FlashPhase::comparing, index, sectors.size());
        heed_interruption();
        if (read_sector(boot_loader, sectors[index].address) != sectors[index].bytes)
            differing.push_back(index);
    }
    on_progress(FlashPhase::comparing, sectors.size(), sectors.size());
    return differing;
}

void write_sectors(BootLoader& boot_loader, const FlashImage& image, const std::vector<std::size_t>& sectors,
                   const FlashProgressCallback& on_progress)
{
    if (!sectors.empty())
        Writing{boot_loader, image, sectors, on_progress}.run();
}

void verify(BootLoader& boot_loader, const FlashImage& image, const FlashProgressCallback& on_progress)
{
    const auto sectors = image.sectors();
    for (std::size_t index = 0; index < sectors.size(); ++index) {
        on_progress(FlashPhase::verifying, index, sectors.size());
        heed_interruption();
        require_sector(boot_loader, sectors[index], another);
    }
    on_progress(FlashPhase::verifying, sectors.size(), sectors.size());
}

}
