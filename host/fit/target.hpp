#pragma once

#include "core/beam/beam_profile.hpp"
#include "host/fit/display.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kfast::fit {

/// A kind of CPU, as far as it determines what code is compiled for it. The Cortex-M0+ runs what the M0 runs.
enum class Processor : std::uint8_t { cortex_m0, cortex_m3, cortex_m4, cortex_m7, cortex_m33 };

inline constexpr std::size_t processor_count = 5;

enum class BusKind : std::uint8_t { spi, parallel_8, parallel_16, i2c, dac };

/// The wires to the panel, or to the converter that drives a beam.
struct Bus {
    BusKind kind = BusKind::spi;
    double clock = 0; ///< Hz: bits of spi, i2c and dac, writes of the parallel ones

    double bytes_per_second() const
    {
        switch (kind) {
        case BusKind::spi:
        case BusKind::dac:
            return clock / 8;
        case BusKind::i2c:
            return clock / 9; // every byte is acknowledged
        case BusKind::parallel_8:
            return clock;
        case BusKind::parallel_16:
            return clock * 2;
        }
        return 0;
    }
};

/// The memory of a part of the rest of a program, besides the player: "slots".
struct Reserved {
    std::string name = {};
    std::size_t flash = 0;
    std::size_t ram = 0;
};

/// A board with its panel or beam, as a fit report sees it. Memory in bytes.
struct Target {
    std::string name;
    Processor processor = Processor::cortex_m0;
    std::string processor_name; ///< as its maker calls it: "cortex-m0+"
    double clock = 0;           ///< Hz
    double cycles = 0; ///< of the clock for an instruction, on average; 0: the default of the processor
    std::size_t flash = 0;
    std::size_t ram = 0;
    Bus bus;
    Display display;                 ///< unless there is a beam
    std::optional<BeamProfile> beam; ///< instead of a panel
    std::size_t band_bytes =
        4096; ///< of each of the two buffers that rows are drawn into, or the points of a beam, 4 for each
    double watchdog = 0; ///< seconds after which its watchdog restarts it without a picture; 0: it has none
    std::vector<Reserved> reserved = {};
    bool has_every_feature = false; ///< whatever the scene needs of the player (core/features.hpp)

    std::size_t reserved_flash() const;
    std::size_t reserved_ram() const;
};

}
