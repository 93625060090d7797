#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kfast {

struct Uf2Family {
    std::uint32_t id;
    std::string_view name;
};

/// Common chips, as listed by microsoft/uf2 in utils/uf2families.json, and those of Raspberry Pi
/// as listed by its SDK.
inline constexpr std::array uf2_families{
    Uf2Family{0xe48bff56, "RP2040"},        Uf2Family{0xe48bff57, "RP2-absolute"},
    Uf2Family{0xe48bff58, "RP2-data"},      Uf2Family{0xe48bff59, "RP2350-ARM-S"},
    Uf2Family{0xe48bff5a, "RP2350-RISC-V"}, Uf2Family{0xe48bff5b, "RP2350-ARM-NS"},
    Uf2Family{0xe48bff55, "CYW43"},         Uf2Family{0x68ed2b88, "SAMD21"},
    Uf2Family{0x55114460, "SAMD51"},        Uf2Family{0xada52840, "NRF52840"},
    Uf2Family{0x5ee21072, "STM32F1"},       Uf2Family{0x57755a57, "STM32F4"},
    Uf2Family{0x2dc309c5, "STM32F411xE"},   Uf2Family{0x53b80f00, "STM32F7"},
    Uf2Family{0x6db66082, "STM32H7"},       Uf2Family{0x300f5633, "STM32G0"},
    Uf2Family{0x4c71240a, "STM32G4"},       Uf2Family{0x00ff6919, "STM32L4"},
    Uf2Family{0x1c5f21b0, "ESP32"},         Uf2Family{0xbfdd4eee, "ESP32S2"},
    Uf2Family{0xc47e5767, "ESP32S3"},       Uf2Family{0xd42ba06c, "ESP32C3"},
    Uf2Family{0x540ddf62, "ESP32C6"},       Uf2Family{0x3d308e94, "ESP32P4"},
    Uf2Family{0x4fb2d5bd, "MIMXRT10XX"},    Uf2Family{0x699b62ec, "CH32V"},
};

/// Returns an empty text if it is none of them.
std::string_view uf2_family_name(std::uint32_t id);

/// The family by its name, in small letters or capitals, or its number: "rp2040", "0xe48bff56".
std::optional<std::uint32_t> uf2_family_called(std::string_view text);

}
