#include "host/link/remote_device.hpp"

#include "host/link/hid_pipe.hpp"
#include "host/link/socket_pipe.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"
#include "host/text/glyph.hpp"

#include <random>

namespace kfast {
namespace {

/// Answers to somebody who left before they came.
void pass_over_old_reports(ReportPipe& pipe)
{
    constexpr int max = 64;
    for (int count = 0; count < max && pipe.receive(Milliseconds{0}); ++count)
        continue;
}

link::Capabilities hello(Session& session)
{
    const auto capabilities = session.ask<link::Capabilities>(link::Hello{});
    if (capabilities.protocol == link::protocol_version)
        return capabilities;
    const bool is_newer = capabilities.protocol > link::protocol_version;
    throw Failure{"its firmware speaks version " + std::to_string(capabilities.protocol) +
                      " of the link, and this kfast version " + std::to_string(link::protocol_version) +
                      (is_newer ? ": update kfast" : ": update the firmware"),
                  ExitStatus::wrong_version};
}

std::string name_of(const link::Capabilities& capabilities, const std::string& otherwise)
{
    const std::string serial = visible(capabilities.serial.view());
    return serial.empty() ? otherwise : serial;
}

std::unique_ptr<ReportPipe> open_pipe(const DeviceAddress& address)
{
    return address.way == DeviceAddress::Way::usb ? open_hid_pipe(address) : open_socket_pipe(address.path);
}

std::uint8_t random_tag()
{
    std::random_device source;
    return static_cast<std::uint8_t>(1 + source() % 255);
}

}

RemoteDevice::RemoteDevice(std::unique_ptr<ReportPipe> pipe, const Session::Options& options,
                           const std::string& name)
    : pipe_{std::move(pipe)}, session_{*pipe_, options}
{
    pass_over_old_reports(*pipe_);
    capabilities_ = hello(session_);
    name_ = name_of(capabilities_, name);
}

RemoteDevice open_device(const DeviceAddress& address, Milliseconds last_patience)
{
    try {
        return {open_pipe(address), {last_patience, random_tag()}, name_of(address)};
    } catch (const Interrupted&) {
        throw;
    } catch (const Failure& failure) {
        throw Failure{visible(name_of(address)) + ": " + failure.what(), failure.status()};
    }
}

}
