#include "firmware/usb/hid_device.hpp"
#include "tests/demand.hpp"
#include "tests/firmware/usb/pretended_controller.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <utility>

namespace kfast::usb {
namespace {

using test::Bytes;
using test::PretendedController;

/// What a hub, a computer and the device's own program do, by the bytes of the fuzzer.
class Bus {
public:
    explicit Bus(std::span<const std::uint8_t> bytes) : bytes_{bytes}
    {
        device_.begin({"Maker", "Product", "0123456789ABCDEF"});
    }

    void run()
    {
        while (!bytes_.empty()) {
            const std::uint32_t connection = device_.connections();
            step();
            if (device_.connections() != connection)
                lose_all();
        }
        drain();
    }

private:
    std::byte random_byte()
    {
        random_ = random_ * 1664525 + 1013904223;
        return static_cast<std::byte>(random_ >> 24);
    }

    struct Sent {
        Bytes bytes;
        bool may_be_lost = false; ///< a computer has begun anew since
    };

    void lose_all()
    {
        for (auto* way : {&from_computer_, &to_computer_})
            for (Sent& sent : *way)
                sent.may_be_lost = true;
    }

    std::uint8_t next()
    {
        if (bytes_.empty())
            return 0;
        const std::uint8_t byte = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return byte;
    }

    void step()
    {
        switch (next() % 16) {
        case 0:
            return reset();
        case 1:
            return device_.suspended();
        case 2:
            return device_.resumed();
        case 3:
            return setup({next(), next(), next(), next(), next(), next(), next(), next()});
        case 4:
            return setup({0x00, 0x09, 1, 0, 0, 0, 0, 0}); // SET_CONFIGURATION 1
        case 5:
            return setup({0x80, 0x06, next(), next(), 0, 0, next(), 0}); // GET_DESCRIPTOR
        case 6:
            return setup({0x21, 0x09, 0, 2, 0, 0, next(), 0}); // SET_REPORT, output
        case 7:
            return setup({0xA1, 0x01, 0, 1, 0, 0, 64, 0}); // GET_REPORT, input
        case 8:
            return setup({0x02, static_cast<std::uint8_t>(next() % 2 == 0 ? 0x01 : 0x03), 0, 0,
                          static_cast<std::uint8_t>(next() % 2 == 0 ? 0x01 : 0x81), 0, 0, 0}); // halts
        case 9:
            return fetch(Endpoint::control_in);
        case 10:
            return put(Endpoint::control_out);
        case 11:
            return fetch(Endpoint::reports_in);
        case 12:
        case 13:
            return put(Endpoint::reports_out);
        case 14:
            take();
            return;
        default:
            return send();
        }
    }

    /// The program takes all, and so does the computer, unless it has not set the device up.
    void drain()
    {
        while (take())
            continue;
        device_.resumed();
        if (!device_.is_connected())
            return;
        demand_arrived(from_computer_);
        if (controller_.of(Endpoint::reports_in).is_stalled)
            setup({0x02, 0x01, 0, 0, 0x81, 0, 0, 0}); // CLEAR_FEATURE, halt
        while (controller_.of(Endpoint::reports_in).given)
            fetch(Endpoint::reports_in);
        demand_arrived(to_computer_);
    }

    static void demand_arrived(const std::deque<Sent>& sent)
    {
        demand(std::ranges::all_of(sent, &Sent::may_be_lost));
    }

    void reset()
    {
        controller_.states = PretendedController{}.states;
        controller_.address = 0;
        const std::uint32_t connections = device_.connections();
        device_.bus_reset();
        demand(!device_.is_connected());
        demand(device_.connections() - connections <= 1);
        lose_all();
    }

    void setup(const std::array<std::uint8_t, setup_bytes>& bytes)
    {
        controller_.of(Endpoint::control_in) = {.is_open = true};
        controller_.of(Endpoint::control_out) = {.is_open = true};
        device_.setup(std::as_bytes(std::span{bytes}));
        // Each request is answered, waits for data, or is refused on both endpoints.
        const auto& in = controller_.of(Endpoint::control_in);
        const auto& out = controller_.of(Endpoint::control_out);
        demand(in.given || out.is_accepting || (in.is_stalled && out.is_stalled));
        is_setting_report_ = bytes[0] == 0x21 && bytes[1] == 0x09 && out.is_accepting;
    }

    /// The computer asks for a packet.
    void fetch(Endpoint endpoint)
    {
        auto packet = std::exchange(controller_.of(endpoint).given, {});
        if (!packet)
            return;
        if (endpoint == Endpoint::reports_in)
            check_order(to_computer_, *packet);
        device_.sent(endpoint);
        demand(controller_.address <= 127);
    }

    /// The computer sends a packet, which the controller refuses unless the device accepts one.
    void put(Endpoint endpoint)
    {
        Bytes packet(8 + next() % (packet_bytes - 7)); // long enough to differ from all others
        std::ranges::generate(packet, [this] { return random_byte(); });
        auto& state = controller_.of(endpoint);
        if (!state.is_accepting)
            return;
        state.is_accepting = false;
        state.arrived = packet;
        device_.received(endpoint);
        const bool is_report = endpoint == Endpoint::reports_out || std::exchange(is_setting_report_, false);
        if (!is_report || state.is_stalled)
            return;
        packet.resize(report_bytes);
        from_computer_.push_back({packet});
    }

    /// Returns whether there was a report.
    bool take()
    {
        const std::optional<Report> report = device_.take();
        if (report)
            check_order(from_computer_, {report->bytes.begin(), report->bytes.end()});
        return report.has_value();
    }

    void send()
    {
        Report report;
        std::ranges::generate(report.bytes, [this] { return random_byte(); });
        if (device_.send(report))
            to_computer_.push_back({{report.bytes.begin(), report.bytes.end()}});
    }

    /// None is invented, changed, repeated or overtaken, and none is lost but where a computer begins anew.
    static void check_order(std::deque<Sent>& sent, const Bytes& came)
    {
        while (!sent.empty() && sent.front().bytes != came) {
            demand(sent.front().may_be_lost);
            sent.pop_front();
        }
        demand(!sent.empty());
        sent.pop_front();
    }

    std::span<const std::uint8_t> bytes_;
    HidDevice<PretendedController> device_;
    PretendedController& controller_ = device_.controller();
    std::deque<Sent> from_computer_;
    std::deque<Sent> to_computer_;
    bool is_setting_report_ = false;
    std::uint32_t random_ = 1;
};

}
}

/// Whatever a computer, a hub and the program do, in any order: the device keeps the rules of its controller,
/// and reports come whole and in order.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    kfast::usb::Bus{{data, size}}.run();
    return 0;
}
