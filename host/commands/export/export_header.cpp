#include "host/commands/export/c_name.hpp"
#include "host/commands/export/export_kinds.hpp"
#include "host/commands/export/scene_header.hpp"
#include "host/commands/options/report_options.hpp"
#include "host/commands/text/summary.hpp"
#include "host/file/atomic_file.hpp"
#include "host/text/counted.hpp"

#include <iostream>
#include <span>

namespace kfast {

void export_header(const ExportOptions& options)
{
    const std::string name = options.name ? *options.name : c_name_for(options.scene);
    const SceneFile scene = load_scene(options.scene);
    const std::filesystem::path output = export_path(options, ".h");
    const SceneHeader header{name, std::filesystem::path{options.scene}.filename().string(),
                             panel_size(options.picture, scene.view)};
    const std::string text = header_text(header, scene);
    write_file(output, std::as_bytes(std::span{text}));
    report_stream(options.quiet) << output.string() << ": " << name << "[], " << contents_summary(scene)
                                 << ", " << counted(block_bytes(header, scene), "byte") << " to be lent at "
                                 << header.panel.width << 'x' << header.panel.height
                                 << ", the player included\n";
}

}
