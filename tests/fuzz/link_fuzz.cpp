#include "firmware/link/link.hpp"
#include "tests/demand.hpp"
#include "tests/firmware/link/pretend_device.hpp"
#include "tests/firmware/slots/pretend_flash.hpp"
#include "tests/firmware/slots/small_places.hpp"
#include "tests/known.hpp"

#include <algorithm>

using namespace kfast;

namespace {

/// A device, and what must hold whatever comes over its link.
class Device {
public:
    /// With the checksum that belongs to it, if it is a whole one and should have one.
    void take_whole(std::span<const std::byte> bytes)
    {
        Report report;
        std::ranges::copy(bytes, report.bytes.begin());
        const Report whole = link::with_checksum(report);
        take(std::span{whole.bytes}.first(bytes.size()));
    }
    void take(std::span<const std::byte> report)
    {
        link_.take(report, now_);
        check();
    }
    void fetch()
    {
        const bool has_report = link_.has_report();
        const auto report = link_.next_report();
        demand(report.has_value() == has_report);
        if (report)
            test::demand_known(std::span{report->bytes});
        demand(!report || (report->kind() & from_device) != 0);
    }
    void pass(std::uint32_t milliseconds)
    {
        now_ = now_ + Microseconds{1000 * milliseconds};
        link_.pass(now_);
    }
    /// All that is to be fetched comes to an end.
    void fetch_all()
    {
        for (int report = 0; report <= 9; ++report)
            fetch();
        demand(!link_.has_report());
    }

private:
    /// What plays stays as it was, what a start finds is what the slots hold, and nothing else is written to.
    void check()
    {
        demand(std::ranges::equal(device_.played(), device_.shown) || !device_.now.is_playing);
        demand(flash_.erased_sectors().front() == 0 && flash_.erased_sectors().back() == 0);
        const SlotStore<test::PretendFlash> restarted{flash_, test::small_places};
        demand(restarted.chosen() == slots_.chosen());
        for (std::uint8_t slot = 0; slot < SlotDirectory::slot_count; ++slot) {
            demand(restarted.entry(slot) == slots_.entry(slot));
            const SlotEntry& entry = slots_.entry(slot);
            Crc32 crc;
            crc.add(slots_.scene(slot));
            demand(entry.is_empty() || (crc.value() == entry.crc && SceneView::parse(slots_.scene(slot))));
        }
    }

    test::PretendFlash flash_{test::small_flash_bytes};
    SlotStore<test::PretendFlash> slots_{flash_, test::small_places};
    test::PretendDevice device_;
    link::Link<test::PretendDevice, test::PretendFlash> link_{device_, slots_};
    Microseconds now_;
};

}

/// A byte says what happens: below 0x80 the 64 bytes behind it come as a report with a right checksum, or as
/// many as are left; below 0xC0 they come as they are; below 0xE0 a report is fetched; from there on, time
/// passes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Device device;
    auto bytes = std::as_bytes(std::span{data, size});
    while (!bytes.empty()) {
        const auto what = std::to_integer<std::uint32_t>(bytes[0]);
        bytes = bytes.subspan(1);
        if (what < 0xC0) {
            const std::size_t count = std::min(bytes.size(), report_bytes);
            what < 0x80 ? device.take_whole(bytes.first(count)) : device.take(bytes.first(count));
            bytes = bytes.subspan(count);
        } else if (what < 0xE0) {
            device.fetch();
        } else {
            device.pass(100 * (what - 0xE0));
        }
    }
    device.fetch_all();
    return 0;
}
