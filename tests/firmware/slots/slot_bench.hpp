#pragma once

#include "firmware/slots/slot_store.hpp"
#include "tests/firmware/slots/padded_scene.hpp"
#include "tests/firmware/slots/pretend_flash.hpp"
#include "tests/firmware/slots/small_places.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::test {

using Store = SlotStore<PretendFlash>;
using Scene = std::vector<std::byte>;

/// All that the slots of a device are.
struct SlotState {
    struct Slot {
        std::string name;
        Scene scene;
        friend bool operator==(const Slot&, const Slot&) = default;
    };
    std::array<Slot, SlotDirectory::slot_count> slots;
    std::optional<std::uint8_t> chosen;

    friend bool operator==(const SlotState&, const SlotState&) = default;
};

inline SlotState state_of(const Store& store)
{
    SlotState state;
    state.chosen = store.chosen();
    for (std::uint8_t slot = 0; slot < SlotDirectory::slot_count; ++slot) {
        const auto scene = store.scene(slot);
        state.slots[slot] = {std::string{store.entry(slot).name.view()}, {scene.begin(), scene.end()}};
    }
    return state;
}

inline SlotUpload upload_of(std::uint8_t slot, std::string_view name, std::span<const std::byte> scene)
{
    return {slot, static_cast<std::uint32_t>(scene.size()), crc_of(scene), {name}};
}

/// In pieces as they come over the link.
inline void write_in_pieces(Store& store, std::span<const std::byte> scene)
{
    for (; !scene.empty(); scene = scene.subspan(std::min<std::size_t>(60, scene.size())))
        store.write(scene.first(std::min<std::size_t>(60, scene.size())));
}

inline Status put(Store& store, std::uint8_t slot, std::string_view name, std::span<const std::byte> scene,
                  std::span<const std::byte> held = {})
{
    if (const StatusWithNumber result = store.begin(upload_of(slot, name, scene), held); !result.is_ok())
        return result.status;
    write_in_pieces(store, scene);
    return store.finish();
}

}
