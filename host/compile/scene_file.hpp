#pragma once

#include "core/scene/scene_view.hpp"
#include "host/art/losses.hpp"
#include "host/compiler/compile.hpp"
#include "host/import/options.hpp"
#include "host/text/reported_diagnostics.hpp"
#include "host/text/source.hpp"

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace kfast {

/// A scene read from disk. `view` looks into `bytes`, hence no copies.
struct SceneFile {
    SceneFile(std::vector<std::byte> compiled, SceneView checked) : bytes{std::move(compiled)}, view{checked}
    {
    }
    SceneFile(SceneFile&&) = default;
    SceneFile(const SceneFile&) = delete;

    std::vector<std::byte> bytes; ///< a .kfb
    SceneView view;
    bool was_text = false;               ///< compiled just now, rather than read as a .kfb
    std::size_t warnings = 0;            ///< of the compiler
    art::Losses losses;                  ///< of a file of another program
    std::vector<std::string> item_names; ///< in the order in which the scene stores items; only of a text
    std::vector<SourceSpan> item_places; ///< in the same order, in `text`; none for an imported file
    StoredNames other_names;             ///< of symbols, skeletons and bones; only of a text
    std::string text;                    ///< of a scene text
    std::vector<std::filesystem::path> fonts; ///< files that a text names
};

/// What is done about things in a file of another program that a scene cannot have.
enum class OnLoss {
    warn,   ///< a line says how many there are
    report, ///< nothing is printed: the caller reports what they are
    refuse, ///< Failure, which lists what they are
};

/// How a file of another program is loaded; scenes of kfast are what they are.
struct ImportChoice {
    importing::Options options = {};
    OnLoss on_loss = OnLoss::warn;
    /// The option that was used for `options`, if any was: scenes of kfast are refused, saying so.
    std::string only_for_imports = {};
};

/// Reads a compiled scene (known by its first bytes, "KFB"), reads and compiles a scene text, or imports a
/// file of another program, whatever the file's name. What the compiler finds is printed to `out`, as
/// report() does. Throws Failure when the file cannot be read, is empty or larger than 16 MB (a scene text: 4
/// MB), or is no valid scene.
SceneFile load_scene(const std::filesystem::path& path, const ImportChoice& choice = {},
                     std::ostream& out = std::cerr);

/// The same for the content of a file, existing or not: `path` is its name, and fonts are beside it. What the
/// compiler finds is passed to `reporter`, and only that an import lost something is printed to `out`.
SceneFile scene_of(const std::filesystem::path& path, std::string content, const ImportChoice& choice,
                   const Reporter& reporter, std::ostream& out = std::cerr);

}
