#pragma once

#include "core/scene/scene_view.hpp"
#include "core/time/velocity_law.hpp"

#include <cstdint>
#include <doctest/doctest.h>

namespace kfast::test {

/// Those of a key; the last one has no way to a next, and its laws are not written.
inline void compare_laws(const SceneView& view, std::uint32_t number, const LawPair& laws, bool is_last)
{
    CHECK(view.laws(number) == (is_last ? LawPair{} : laws));
}

}
