#pragma once

#include "host/flash/boot_board.hpp"
#include "host/flash/flash_image.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace kfast {

enum class FlashPhase { comparing, writing, verifying };

/// Called with how many sectors of a phase are done, from 0 on.
using FlashProgressCallback = std::function<void(FlashPhase phase, std::size_t done, std::size_t total)>;

/// The sectors of `image`, by their indices, that flash holds differently. Throws what BootLoader throws, and
/// Interrupted.
std::vector<std::size_t> differing_sectors(BootLoader& boot_loader, const FlashImage& image,
                                           const FlashProgressCallback& on_progress);

/// Writes these sectors of `image` and verifies them; nothing if there are none. The first sector of the
/// image, which is what makes a board start it, is erased before anything else is touched and written after
/// everything else has been verified, whether it differs or not, and its first page last: a board on which
/// this was interrupted starts nothing, and can be flashed again.
///
/// Throws what BootLoader throws, Failure with not_verified (address, expected, found), and Interrupted.
void write_sectors(BootLoader& boot_loader, const FlashImage& image, const std::vector<std::size_t>& sectors,
                   const FlashProgressCallback& on_progress);

/// Throws Failure with not_verified if flash does not hold `image`, and as write_sectors().
void verify(BootLoader& boot_loader, const FlashImage& image, const FlashProgressCallback& on_progress);

}
