#include "core/scene/item_view.hpp"

#include "tests/core/raw_scene.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("items are read one after the other, whatever they hold")
{
    const auto items = bytes({0x0D, 1, 0x80, 2, 2, 2, 7, // a group with a track, in it a use
                              0x06, 1, 0x81, 4, 9,       // a use with a track
                              0x08, 5, 0, 0});           // an object
    ItemCursor cursor{ByteReader{items}};
    const ItemView group = cursor.next();
    CHECK(group.kind == ItemKind::group);
    CHECK_FALSE(group.is_known); // it says that it is filled
    CHECK(TrackCursor{group.tracks}.next().value == 1);
    const ItemView inside = ItemCursor{group.items}.next();
    CHECK(inside.kind == ItemKind::use);
    CHECK(inside.symbol == 7);
    CHECK(inside.tracks.at_end());
    const ItemView use = cursor.next();
    CHECK(use.is_known);
    CHECK(use.symbol == 9);
    CHECK(TrackCursor{use.tracks}.next().property == Property::y);
    const ItemView object = cursor.next();
    CHECK(object.kind == ItemKind::object);
    CHECK(object.object.style.fill == 5);
    CHECK(cursor.at_end());
    CHECK_FALSE(cursor.overrun());
}

TEST_CASE("the style of an object, all of it")
{
    const auto items = bytes({0x38, 1, 2, 0xA0, 1, 0x02, 12, 0, 0, //
                              0x10, 3, 16, 0x05, 0, 0});
    ItemCursor cursor{ByteReader{items}};
    const ObjectStyle both = cursor.next().object.style;
    CHECK(both.is_filled);
    CHECK(both.is_stroked);
    CHECK(both.fill_rule == FillRule::even_odd);
    CHECK(both.fill == 1);
    CHECK(both.stroke == 2);
    CHECK(both.width == 160);
    CHECK(both.cap == Cap::square);
    CHECK(both.join == Join::miter);
    CHECK(both.miter_limit == 12);
    const ObjectStyle wire = cursor.next().object.style;
    CHECK_FALSE(wire.is_filled);
    CHECK(wire.fill_rule == FillRule::nonzero);
    CHECK(wire.cap == Cap::round);
    CHECK(wire.join == Join::round);
    CHECK(wire.miter_limit == default_miter_limit); // not stored: it has no miters
    CHECK(cursor.at_end());
}

TEST_CASE("keys have times, laws and drawings, maybe arrival drawings")
{
    const Bytes items =
        joined({bytes({0x48, 1}), key_bytes({{Time::frame(2), 2, 10, 20}, {{2 * 1024 + 3}, 0, 30, 40}})});
    const ObjectView object = ItemCursor{ByteReader{items}}.next().object;
    CHECK(object.has_arrivals);
    KeyCursor keys = object.keys();
    const Key first = keys.next();
    CHECK(first.time == Time::frame(2));
    CHECK(first.laws == 2);
    CHECK(first.drawing == 10);
    CHECK(first.arrival == 20);
    const Key second = keys.next();
    CHECK(second.time == Time{2 * 1024 + 3});
    CHECK(second.arrival == 40);
    CHECK(keys.at_end());
}

TEST_CASE("an object may be carried by bones, each key with a skin")
{
    const Bytes items =
        joined({bytes({0x88, 1, 3}), key_bytes({{Time::frame(2), 2, 10, 20}, {{2 * 1024 + 3}, 0, 30, -5}})});
    const ObjectView object = ItemCursor{ByteReader{items}}.next().object;
    CHECK(object.deformer == Deformer::bones);
    CHECK(object.skeleton == 2);
    KeyCursor keys = object.keys();
    CHECK(keys.next().more == 20);
    const Key second = keys.next();
    CHECK(second.drawing == 30);
    CHECK(second.more == -5);
    CHECK(keys.at_end());
}

TEST_CASE("an object may be carried by backbones, which have keys of their own")
{
    const Bytes items =
        joined({bytes({0xC8, 1, 0, 9}), key_bytes({{Time::frame(2), 2, 10}, {{2 * 1024 + 3}, 0, 129}}),
                bytes({0, 60, 80}), bytes({0x08, 2, 0, 0})});
    ItemCursor cursor{ByteReader{items}};
    const ObjectView object = cursor.next().object;
    CHECK(object.deformer == Deformer::backbones);
    CHECK(object.backbones.unit_bits == 9);
    BackboneKeyCursor backbones = object.backbones.keys();
    const BackboneKey first = backbones.next();
    CHECK(first.time == Time::frame(2));
    CHECK(first.laws == 2);
    CHECK(first.drawing == 10);
    const BackboneKey second = backbones.next();
    CHECK(second.time == Time{2 * 1024 + 3});
    CHECK(second.drawing == 129);
    CHECK(backbones.at_end());
    CHECK(object.keys().next().drawing == 30);
    CHECK(object.keys().next().arrival == 40);
    CHECK(cursor.next().object.style.fill == 2);
    CHECK(cursor.at_end());
}

TEST_CASE("a path follows the tracks where one of them leads along it, whatever the item is")
{
    const auto items = bytes({0x05, 2, 0x80, 2, 0x8A, 4, 4, 1,  9, 20, 30, 0, // a group
                              0x06, 1, 0x4A, 1, 0,    0, 0, 3,  0, 9,  20, 7, // a use
                              0x0C, 1, 0x80, 2, 1,    0, 0,                   // an object without a path
                              0x0C, 1, 0x8A, 2, 3,    2, 9, 20, 1, 0,  0});   // bits without a meaning
    ItemCursor cursor{ByteReader{items}};
    const ItemView group = cursor.next();
    CHECK(group.is_known);
    CHECK(group.path.is_known);
    CHECK(group.path.turns);
    CHECK(group.path.drawing == 9);
    ByteReader lengths = group.path.lengths;
    CHECK(lengths.varint() == 20);
    CHECK(lengths.varint() == 30);
    CHECK(lengths.left() == 0);
    const ItemView use = cursor.next();
    CHECK(use.path.is_known);
    CHECK_FALSE(use.path.turns);
    CHECK(use.symbol == 7);
    CHECK_FALSE(cursor.next().path.is_known);
    CHECK_FALSE(cursor.next().is_known);
    CHECK(cursor.at_end());
    CHECK_FALSE(cursor.overrun());
}

TEST_CASE("bits that only objects have are known in objects alone")
{
    const auto is_known = [](int head) {
        const auto item =
            bytes({head, 1, 0x80, 2, 0, 0, 0, 0, 0, 0, 0}); // one track, for those that have any
        return ItemCursor{ByteReader{item}}.next().is_known;
    };
    CHECK(is_known(0xFC));
    CHECK(is_known(0x05));
    CHECK(is_known(0x06));
    CHECK(is_known(0x03));
    CHECK_FALSE(is_known(0x43));
    CHECK_FALSE(is_known(0x83));
    for (const int bit : {0x08, 0x10, 0x20, 0x40, 0x80}) {
        CHECK(is_known(bit));
        CHECK_FALSE(is_known(1 | bit));
        CHECK_FALSE(is_known(2 | bit));
    }
}

TEST_CASE("an item that breaks off anywhere is noticed")
{
    const auto styled = bytes({0x3C, 1, 0x80, 2, 1, 2, 16, 0x00, 12, 0, 0});
    const auto following = bytes({0x0C, 1, 0x8A, 2, 3, 1, 9, 20, 1, 0, 0});
    const auto on_backbones = bytes({0x88, 1, 0, 9, 0, 4, 0, 0});
    const Bytes moving = joined({bytes({0x48, 1}), key_bytes({{{}, 2, 10, 20}, {{9}, 0, 300, 40}})});
    for (const auto& whole : {styled, following, on_backbones, moving})
        for (std::size_t count = 1; count < whole.size(); ++count) {
            ItemCursor cursor{ByteReader{std::span{whole}.first(count)}};
            cursor.next();
            CHECK(cursor.overrun());
        }
}

}
