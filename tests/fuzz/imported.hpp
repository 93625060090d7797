#pragma once

#include "host/import/content_kind.hpp"
#include "host/import/import_scene.hpp"
#include "host/program/failure.hpp"

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>

namespace kfast::test {

/// Any bytes at all: they are refused, or become a scene that compiles without errors and warnings. What says
/// that kfast is wrong is a finding.
inline void check_import(std::string content)
{
    try {
        importing::import_scene("fuzz", std::move(content), {});
    } catch (const Failure& failure) {
        // Elsewhere in a message the words can only come from the bytes.
        if (!std::string_view{failure.what()}.starts_with("fuzz: no scene can be made of it"))
            return;
        std::cerr << failure.what() << '\n';
        std::abort();
    }
}

/// Of texts whose outermost element is that.
inline void check_xml(const std::uint8_t* data, std::size_t size, std::string_view root)
{
    std::string content(data, data + size);
    if (importing::kind_of(content) == importing::ContentKind::xml &&
        importing::root_element(content) == root)
        check_import(std::move(content));
}

}
