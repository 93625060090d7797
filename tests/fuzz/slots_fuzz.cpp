#include "firmware/link/scene_library.hpp"
#include "firmware/link/upload.hpp"
#include "tests/demand.hpp"
#include "tests/firmware/link/pretend_device.hpp"
#include "tests/firmware/slots/slot_bench.hpp"
#include "tests/fuzz/any_flash.hpp"
#include "tests/fuzz/input.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

using namespace kfast;
using namespace kfast::test;

namespace {

/// What a device has from one start to the next.
struct Started {
    explicit Started(PretendFlash& flash) : slots{flash, small_places} {}

    Store slots;
    PretendDevice device;
    link::Upload<PretendDevice, PretendFlash> upload{device, slots};
    link::SceneLibrary<PretendDevice, PretendFlash> library{device, slots, upload};
};

/// A device whose flash holds what the fuzzer wants, and all that is done with its slots.
class Device {
public:
    explicit Device(FuzzInput& input) : input_{input}
    {
        FlashFiller filler{flash_, input_};
        filler.fill();
        is_spoiled_ = filler.is_spoiled();
        has_one_history_ = filler.has_one_history();
        others_ = others();
        restart();
        expected_ = state_of(slots());
    }

    void run()
    {
        for (int steps = 0; steps < 40 && !input_.at_end(); ++steps) {
            before_ = expected_;
            try {
                step();
            } catch (const PowerCut&) {
                restart();
                demand(!has_one_history_ || state_of(slots()) == before_ || state_of(slots()) == expected_);
                expected_ = state_of(slots());
            }
            check();
        }
        restart();
        check();
    }

private:
    Store& slots() { return started_->slots; }
    std::uint8_t any_slot() { return input_.below(SlotDirectory::slot_count); }

    /// The sectors that belong to others.
    std::vector<std::byte> others() const
    {
        std::vector<std::byte> bytes;
        for (const auto part :
             {flash_.contents().first(small_places.directory), flash_.contents().last(sector_bytes)})
            bytes.insert(bytes.end(), part.begin(), part.end());
        return bytes;
    }

    void check()
    {
        demand(state_of(slots()) == expected_);
        demand(others() == others_);
        const PretendDevice& device = started_->device;
        demand(!device.now.is_playing || std::ranges::equal(device.played(), device.shown));
    }

    void step()
    {
        switch (input_.below(10)) {
        case 0:
            return restart();
        case 1:
            return erase();
        case 2:
            return choose();
        case 3:
            return play({.home = link::Home::slot, .slot = input_.u8()});
        case 4:
            return play({.home = link::Home::start});
        case 5:
            return spoil();
        case 6:
            return flash_.cut(input_.u8(), static_cast<Remains>(input_.below(4)), input_.u8());
        case 7:
            return begin_only();
        default:
            return upload();
        }
    }

    void restart()
    {
        flash_.power_again();
        started_ = std::make_unique<Started>(flash_);
    }

    void erase()
    {
        const std::uint8_t slot = any_slot();
        const bool is_empty = slots().entry(slot).is_empty();
        expected_.slots[slot] = {};
        if (expected_.chosen == slot)
            expected_.chosen.reset();
        expect(slots().erase(slot), is_empty ? Status::empty_slot : Status::ok);
    }

    void choose()
    {
        const std::uint8_t choice = input_.below(SlotDirectory::slot_count + 1);
        const auto slot = choice < SlotDirectory::slot_count ? std::optional{choice} : std::nullopt;
        const bool is_empty = slot && slots().entry(*slot).is_empty();
        expected_.chosen = slot;
        expect(slots().choose(slot), is_empty ? Status::empty_slot : Status::ok);
    }

    /// What plays is a scene, and the checksum of its slot is right.
    void play(const link::Play& what)
    {
        const auto& selection = started_->device.selection;
        if (!started_->library.play(what).is_ok() || selection.home != link::Home::slot)
            return;
        demand(slots().entry(selection.slot).crc == crc_of(slots().scene(selection.slot)));
        demand(selection.scene.data() == slots().scene(selection.slot).data());
        demand(selection.scene.size() <= slots().scene(selection.slot).size());
    }

    void spoil()
    {
        const std::uint32_t sector = 1 + input_.below(2 + pool_sectors + 2);
        flash_.spoil(sector * sector_bytes, every_fault[input_.below(every_fault.size())]);
        is_spoiled_ = true;
    }

    /// A scene, or what the fuzzer takes for one.
    Scene any_scene()
    {
        if (const std::uint32_t size = input_.u16() % 0x4000; size != 0)
            return padded_scene(size, input_.u8());
        const auto bytes = input_.take(input_.u8());
        return {bytes.begin(), bytes.end()};
    }

    /// It never ends.
    void begin_only()
    {
        const Scene scene = any_scene();
        if (!scene.empty() && slots().begin(upload_of(any_slot(), "never", scene), held()).is_ok())
            write_in_pieces(slots(), std::span{scene}.first(scene.size() / 2));
    }

    void upload()
    {
        const Scene scene = any_scene();
        if (scene.empty())
            return;
        SlotUpload what = upload_of(any_slot(), std::string(1, static_cast<char>(input_.u8())), scene);
        const bool is_right = input_.u8() % 8 != 0;
        what.crc += is_right ? 0 : 1;
        expected_.slots[what.slot] = {std::string{what.name.view()}, scene};
        const StatusWithNumber begun = slots().begin(what, held());
        if (!begun.is_ok())
            return expect_refused(begun, scene.size());
        write_in_pieces(slots(), scene);
        const Status status = slots().finish();
        const bool is_scene = static_cast<bool>(SceneView::parse(scene, every_feature_but_outlines));
        demand(status != Status::ok || (is_right && is_scene && slots().entry(what.slot).crc == what.crc));
        expect(status, is_right && is_scene ? Status::ok : status);
    }

    std::span<const std::byte> held() { return started_->device.played(); }

    void expect_refused(const StatusWithNumber& begun, std::size_t size)
    {
        expected_ = before_;
        demand(begun.status == Status::no_room ? slots().longest_room(held()) < size : is_spoiled_);
    }

    /// What fails changes nothing, and flash alone may make fail what would be right.
    void expect(Status status, Status right)
    {
        demand(status == right || (is_spoiled_ && status == Status::flash_failed));
        if (status != Status::ok)
            expected_ = before_;
    }

    FuzzInput& input_;
    PretendFlash flash_{small_flash_bytes};
    std::unique_ptr<Started> started_;
    SlotState expected_;
    SlotState before_; ///< the step that is under way
    std::vector<std::byte> others_;
    bool is_spoiled_ = false; ///< some sectors do not hold what they are given
    bool has_one_history_ = false;
};

}

/// Whatever a flash holds, and whichever of its sectors are bad: what belongs to others stays, slots hold
/// what was put into them, and what a checksum denies is not played.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    FuzzInput input{std::as_bytes(std::span{data, size})};
    Device{input}.run();
    return 0;
}
