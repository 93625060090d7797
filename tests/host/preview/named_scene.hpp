#pragma once

#include "core/scene/scene_view.hpp"
#include "host/compiler/compile.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::test {

/// A scene text that must compile, with the names of its items.
class NamedScene {
public:
    explicit NamedScene(std::string_view text) : compiled_{made_of(text)}, view_{*SceneView::parse(bytes())}
    {
    }
    NamedScene(const NamedScene&) = delete;

    const std::vector<std::byte>& bytes() const { return compiled_.bytes; }
    const SceneView& view() const { return view_; }
    const std::vector<std::string>& names() const { return compiled_.item_names; }
    /// The place of the first item of that name.
    std::size_t number(std::string_view name) const
    {
        const auto place = std::ranges::find(names(), name);
        if (place == names().end())
            throw std::runtime_error{"no such item"};
        return static_cast<std::size_t>(place - names().begin());
    }

private:
    static CompiledScene made_of(std::string_view text)
    {
        Diagnostics diagnostics;
        const SourceText source{"test.kfast", std::string{text}};
        auto compiled = compile_with_names(source, diagnostics);
        if (!compiled)
            throw std::runtime_error{format(diagnostics.sorted().front(), source)};
        return std::move(*compiled);
    }

    CompiledScene compiled_;
    SceneView view_;
};

}
