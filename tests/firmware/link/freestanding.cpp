#include "firmware/link/link.hpp"
#include "firmware/link/told_drawing.hpp"
#include "firmware/rp2040_flash.hpp"

static_assert(__STDC_HOSTED__ == 0, "compiled with -ffreestanding");

namespace kfast::test {

/// What a board has to bring along, declared alone.
struct BoardFlash {
    void erase(std::uint32_t offset);
    void program(std::uint32_t offset, std::span<const std::byte, page_bytes> page);
    std::span<const std::byte> contents() const;
};

struct BoardDevice {
    link::DeviceFacts facts() const;
    link::Playing playing() const;
    link::Statistics statistics() const;
    std::span<const std::byte> played() const;
    std::span<const std::byte> built_in() const;
    Status play(const link::Programme& programme);
    std::span<std::byte> lend_ram(std::uint32_t size);
    void pause();
    void resume();
    void seek(Time time);
    void set_speed(std::int32_t speed);
    Status set_brightness(std::uint8_t brightness);
    void set_input(std::uint32_t number, Time place);
    Status tell(const link::DrawingPart& part);
    Status enter_boot_loader();
};

}

// So the templates are compiled as well.
template class kfast::SlotStore<kfast::test::BoardFlash>;
template class kfast::link::Link<kfast::test::BoardDevice, kfast::test::BoardFlash>;
static_assert(sizeof(kfast::SlotStore<kfast::test::BoardFlash>) < 5000);
static_assert(sizeof(kfast::link::Link<kfast::test::BoardDevice, kfast::test::BoardFlash>) < 1000);
kfast::Status (*const compiled_as_well)(kfast::Player&, const kfast::link::DrawingPart&) = kfast::link::tell;
static_assert(kfast::rp2040::slot_places.pool_bytes == 1528 * 1024);
