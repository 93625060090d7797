#include "host/beam/beam_text.hpp"
#include "tests/demand.hpp"

#include <cstdint>
#include <string>

using namespace kfast;

/// Any bytes at all: they are refused with messages that can be shown, or are a profile within its ranges,
/// which comes back from its text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const SourceText source{.name = "fuzz", .text = std::string(data, data + size)};
    Diagnostics diagnostics;
    const auto beam = read_beam_text(source, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.sorted()) {
        demand(diagnostic.place.offset <= source.text.size());
        demand(!format(diagnostic, source).empty());
    }
    demand(beam.has_value() == !diagnostics.has_errors());
    if (!beam)
        return 0;

    const BeamProfile& profile = beam->profile;
    demand(profile.rate >= 1000 && profile.rate <= 1'000'000 && profile.lit_step >= 1);
    demand(profile.min_refresh >= 1 && profile.rate / profile.min_refresh >= 16);
    Diagnostics again;
    demand(read_beam_text({.name = "text", .text = beam_text(profile)}, again)->profile == profile);
    return 0;
}
