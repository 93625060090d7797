#include "firmware/link/link_service.hpp"
#include "firmware/settings/rp2040_flash.hpp"

static_assert(__STDC_HOSTED__ == 0, "compiled with -ffreestanding");

namespace kfast::test {

/// What a board has to bring along, declared alone.
struct BoardFlash {
    void erase(std::uint32_t offset);
    void program(std::uint32_t offset, std::span<const std::byte, page_bytes> page);
    std::span<const std::byte> contents() const;
};

struct BoardPipe {
    std::optional<Report> take();
    bool send(const Report& report);
    bool is_connected();
    std::uint32_t connections();
};

}

// So the templates are compiled as well.
template class kfast::SlotStore<kfast::test::BoardFlash>;
template class kfast::link::Link<kfast::link::PlaybackSession, kfast::test::BoardFlash>;
template class kfast::link::LinkService<kfast::test::BoardPipe, kfast::test::BoardFlash>;
static_assert(sizeof(kfast::SlotStore<kfast::test::BoardFlash>) < 5000);
static_assert(sizeof(kfast::link::LinkService<kfast::test::BoardPipe, kfast::test::BoardFlash>) < 1200);
static_assert(kfast::rp2040::slot_places.pool_bytes == 1520 * 1024);
