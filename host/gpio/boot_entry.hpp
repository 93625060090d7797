#pragma once

#include <string>

namespace kfast {

/// Lines of a Linux computer that are wired to an RP2040, as GpioOutputs names them.
struct BootLines {
    std::string chip;  ///< may be empty
    std::string reset; ///< to RUN
    std::string boot;  ///< through a resistor to BOOTSEL
};

/// Restarts an RP2040 with BOOTSEL held, so that its boot loader runs; USB sees it some time after. Both
/// lines are open drain, so buttons on the same wires do no harm, and both are free again when this returns
/// or throws.
///
/// Takes an eighth of a second. A signal meanwhile should only be remembered (RememberedInterruption): one
/// that ends the program leaves lines as they are.
///
/// Throws Failure as GpioOutputs does.
void enter_boot_loader(const BootLines& lines);

}
