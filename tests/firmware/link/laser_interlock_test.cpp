#include "firmware/link/laser_interlock.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace kfast::link {
namespace {

std::vector<bool> changes;

void note(bool is_armed) { changes.push_back(is_armed); }

}

TEST_CASE("a beam is told what changes, and nothing else")
{
    changes.clear();
    LaserInterlock interlock{note};
    CHECK(interlock.disarm() == Status::ok);
    interlock.lose_computer();
    CHECK(changes.empty()); // it begins dark
    CHECK(interlock.arm() == Status::ok);
    CHECK(interlock.arm() == Status::ok);
    CHECK(interlock.disarm() == Status::ok);
    CHECK(interlock.disarm() == Status::ok);
    interlock.toggle();
    interlock.toggle();
    CHECK(changes == std::vector{true, false, true, false});
}

}
