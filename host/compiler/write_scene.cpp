#include "host/compiler/write_scene.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/compiler/limits/allowance.hpp"
#include "host/compiler/limits/outline_needs.hpp"
#include "host/compiler/pack/drawing_pool.hpp"
#include "host/compiler/pack/key_time_writer.hpp"
#include "host/compiler/write/bone_writer.hpp"
#include "host/compiler/write/header.hpp"
#include "host/compiler/write/inputs_and_marks.hpp"
#include "host/compiler/write/item_writer.hpp"

#include <string>

namespace kfast {
namespace {

void write_symbols(const scene::Scene& scene, ItemWriter& writer, ByteWriter& bytes)
{
    for (const scene::Symbol& symbol : scene.symbols) {
        ByteWriter items;
        writer.write(symbol.items, items);
        bytes.block(items.bytes());
    }
}

void check_laws(const LawTable& laws, Diagnostics& diagnostics)
{
    if (const auto place = laws.first_beyond())
        diagnostics.error(*place,
                          "the format holds " + std::to_string(kfb::max_law_pairs) +
                              " different pairs of velocity laws; this is one more",
                          "use laws again that other keys have");
}

}

std::optional<std::vector<std::byte>> write_scene(const scene::Scene& scene, Diagnostics& diagnostics,
                                                  const ProgressCallback& on_progress)
{
    LawTable laws;
    DrawingPool drawings;
    ItemWriter writer{laws, drawings, diagnostics};
    ByteWriter inputs;
    ByteWriter marks;
    ByteWriter bones;
    ByteWriter symbols;
    ByteWriter items;
    write_inputs(scene.inputs, drawings, inputs);
    write_marks(scene, marks);
    write_bones(scene.bones, laws, bones);
    write_symbols(scene, writer, symbols);
    writer.write(scene.items, items);

    check_allowances(scene, diagnostics);
    check_laws(laws, diagnostics);
    if (diagnostics.has_errors())
        return std::nullopt;

    ByteWriter body;
    const Sections sections{.inputs = !scene.inputs.empty(),
                            .marks = !scene.clocks.empty() || !scene.clips.empty() || !scene.events.empty(),
                            .bones = !scene.bones.empty(),
                            .symbols = !scene.symbols.empty()};
    write_header(scene, sections, body);
    body.u8(static_cast<std::uint32_t>(laws.count()));
    body.append(laws.bytes());
    if (sections.inputs) {
        body.u8(static_cast<std::uint32_t>(scene.inputs.size()));
        body.block(inputs.bytes());
    }
    if (sections.marks)
        body.block(marks.bytes());
    if (sections.bones)
        body.block(bones.bytes());
    if (sections.symbols) {
        body.u8(static_cast<std::uint32_t>(scene.symbols.size()));
        body.block(symbols.bytes());
    }
    body.block(items.bytes());
    body.append(drawings.bytes());
    std::vector<std::byte> file = sealed(body);
    const auto needs = outline_needs(file, scene, diagnostics, on_progress);
    if (!needs)
        return std::nullopt;
    set_outline_needs(file, *needs);
    if (!playable(file, scene, diagnostics))
        return std::nullopt;
    return file;
}

}
