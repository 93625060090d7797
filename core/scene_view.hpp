#pragma once

#include "core/colour.hpp"
#include "core/result.hpp"
#include "core/size.hpp"
#include "core/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A checked, borrowed look at the bytes of a compiled scene (docs/format.md).
///
/// Everything that can be wrong with the bytes is found by parse(). Every other member is total: it cannot
/// fail and does not look twice.
class SceneView {
public:
    /// `bytes` must outlive the view; more bytes than the scene has are ignored.
    /// Fails with truncated, bad_magic, unsupported_version, bad_checksum or bad_scene.
    static Result<SceneView> parse(std::span<const std::byte> bytes);

    Size canvas() const;
    /// Frames in 1000 seconds: 30 fps is 30000.
    std::uint32_t frame_rate() const;
    /// At least one frame.
    Time length() const;
    Loop loop() const;
};

}
