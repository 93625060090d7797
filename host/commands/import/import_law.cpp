#include "host/commands/import/import_law.hpp"

#include "host/scene/values/law_reader.hpp"
#include "host/schema/report.hpp"

#include <CLI/CLI.hpp>

namespace kfast {
namespace {

VelocityLaw read_law(const std::string& option, const std::string& text)
{
    const SourceText source{.name = option, .text = text};
    Diagnostics diagnostics;
    schema::Report report{source, diagnostics};
    const kdl::Value value{.type = {}, .data = text, .place = {0, text.size()}, .text_offset = 0};
    if (const auto law = scene::read_law(value, report))
        return *law;
    const Diagnostic first = diagnostics.sorted().front();
    throw CLI::ValidationError(option, first.message + (first.hint.empty() ? "" : ": " + first.hint));
}

double control(std::int16_t number) { return static_cast<double>(number) / VelocityLaw::control_one; }

}

art::Ease read_ease(const std::string& option, const std::string& text)
{
    const VelocityLaw law = read_law(option, text);
    switch (law.kind) {
    case VelocityLaw::Kind::constant:
        return {};
    case VelocityLaw::Kind::hold:
        return {.kind = art::EaseKind::hold};
    case VelocityLaw::Kind::bezier:
        return {art::EaseKind::cubic, control(law.x1), control(law.y1), control(law.x2), control(law.y2)};
    case VelocityLaw::Kind::accelerate:
    case VelocityLaw::Kind::decelerate:
    case VelocityLaw::Kind::accelerate_decelerate:
    case VelocityLaw::Kind::steps:
        break;
    }
    throw CLI::ValidationError(option,
                               '\'' + text +
                                   "' cannot be imported: take constant, hold, ease, ease-in, ease-out, "
                                   "ease-in-out or bezier(x1,y1,x2,y2)");
}

}
