#include "core/bytes/bit_field.hpp"

#include "core/scene/format.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// Whether each value of a field comes back from where it was put, and from nowhere else.
template <class Field>
bool goes_round(Field field)
{
    const std::uint32_t max = field.max();
    for (const std::uint32_t value : {std::uint32_t{0}, std::uint32_t{1}, max / 2, max})
        if (field.get(field.put(value)) != value)
            return false;
    return field.get(~field.put(max)) == 0;
}

}

TEST_CASE("a field of bits has the value that was put into it")
{
    CHECK(goes_round(BitField<0, 1>{}));
    CHECK(goes_round(BitField<5, 4>{}));
    CHECK(goes_round(BitField<0, 32>{}));
    CHECK(goes_round(BitField<31, 1>{}));
    CHECK(goes_round(BitField<8, 24>{}));
    CHECK(BitField<5, 4>::put(9) == 9 << 5);
    CHECK(BitField<5, 4>::get(0xFFFF'FFFF) == 15);
}

TEST_CASE("the highest field of a number has no bits above it")
{
    CHECK(BitField<5, 3, 8>::get(0xFF) == 7);
    CHECK(BitField<5, 3, 8>::put(7) == 0xE0);
    CHECK(BitField<2, 2>::get_with_above(0xFF) == 63);
}

TEST_CASE("a flag is one bit")
{
    CHECK(BitFlag<7>::put(true) == 0x80);
    CHECK(BitFlag<7>::put(false) == 0);
    CHECK(BitFlag<7>::get(0x80));
    CHECK_FALSE(BitFlag<7>::get(0x7F));
    CHECK(BitFlag<31>::mask() == 0x8000'0000);
}

TEST_CASE("the fields of a record do not overlap and fill it")
{
    using namespace kfb;
    CHECK((header::loop.put(header::loop.max()) ^ header::has_camera.mask() ^ header::has_opacity.mask() ^
           header::has_marks.mask() ^ header::has_bones.mask() ^ header::has_symbols.mask() ^
           header::has_inputs.mask()) == 0xFF);
    CHECK((key_times::time_width.put(31) ^ key_times::time_shift.put(15) ^ key_times::law_width.put(63) ^
           key_times::has_driver.mask()) == 0xFFFF);
    CHECK((item::kind.put(3) ^ item::has_tracks.mask() ^ item::is_filled.mask() ^ item::is_stroked.mask() ^
           item::is_even_odd.mask() ^ item::has_arrivals.mask() ^ item::is_carried.mask()) == 0xFF);
    CHECK((form::mix.put(3) ^ form::end.put(3) ^ form::has_sparse_ends.mask() ^
           form::has_sparse_controls.mask() ^ form::smoothness.put(3) ^ form::end_width.put(31) ^
           form::less_control_width.put(7)) == 0xFFFF);
    CHECK((bone::moved.put(15) ^ bone::is_at_tip.mask() ^ bone::turns_as_written.mask() ^
           bone::is_straight.mask() ^ bone::in_pixels.mask()) == 0xFF);
}

}
