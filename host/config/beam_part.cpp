#include "host/config/beam_part.hpp"

#include "host/beam/beam_reader.hpp"
#include "host/config/setting_words.hpp"
#include "host/schema/value_reader.hpp"

namespace kfast::config {

bool read_beam_part(const kdl::Node& node, Draft& draft, schema::Report& report)
{
    draft.beam = &node;
    return schema::assign(read_beam(node, report), draft.settings.beam);
}

bool check_display(const kdl::Node& board, const Draft& draft, schema::Report& report)
{
    if (draft.beam == nullptr && draft.panel == nullptr)
        return report.error(board.name_span, "board has neither a panel nor a beam",
                            "add \"panel st7789\", or \"beam scope\" for a vector display");
    if (draft.beam != nullptr && draft.panel != nullptr)
        return report.error(draft.beam->name_span, "a board has a panel or a beam, not both",
                            "remove one of them");
    if (draft.bus == nullptr)
        return false; // which was reported
    const bool leads = leads_beam(draft.settings.bus);
    const SourceSpan bus = draft.bus->arguments.front().place;
    if (leads && draft.beam == nullptr)
        return report.error(bus, "bus dac leads a beam, and there is a panel",
                            "write another bus, or a beam in place of the panel");
    if (!leads && draft.beam != nullptr)
        return report.error(bus, word_of(draft.settings.bus) + " cannot lead a beam", "write bus dac");
    return true;
}

}
