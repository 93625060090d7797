#include "host/compiler/limits/largest_texts.hpp"

#include "host/walk/input_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>

namespace kfast {
namespace {

constexpr std::size_t max_samples = 24;

std::size_t glyph_count(const SceneView& scene)
{
    std::size_t count = 0;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();)
        if (const InputView input = inputs.next(); input.type == InputType::text)
            count += input.text.glyphs.count();
    return count;
}

/// All glyphs are looked at in each.
std::vector<MeasuredMoment> samples_of(const SceneView& scene, std::span<const MeasuredMoment> moments)
{
    const std::size_t affordable =
        std::max<std::size_t>(affordable_pictures(scene) / std::max<std::size_t>(glyph_count(scene), 1), 1);
    const std::size_t count = std::min({moments.size(), max_samples, affordable});
    std::vector<MeasuredMoment> samples;
    for (std::size_t i = 0; i < count; ++i)
        samples.push_back(moments[i * moments.size() / count]);
    return samples;
}

/// The character that needs most at one moment.
struct Largest {
    std::uint32_t glyph = 0;
    std::size_t max = 0;
    std::size_t min = 0; ///< of any character

    /// Else the text is not seen.
    bool is_visible() const { return max != min; }
};

/// The characters that need most at some of the samples, and the one that has most points: the text may be
/// seen at other moments.
std::set<std::uint32_t> largest_glyphs(const SceneView& scene, std::uint32_t number, const TextInput& input,
                                       const std::vector<MeasuredMoment>& samples, OutlineMeter& meter)
{
    std::vector<Largest> largest(samples.size());
    for (std::uint32_t glyph = 0; glyph < input.glyphs.count(); ++glyph) {
        meter.put_text(number, full_text(input, glyph));
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const std::size_t bytes = meter.picture_at(samples[i].moment()).outlines.needed_bytes();
            Largest& at = largest[i];
            at.min = glyph == 0 ? bytes : std::min(at.min, bytes);
            if (glyph == 0 || bytes > at.max)
                at = {glyph, bytes, at.min};
        }
    }
    const std::vector<std::size_t> points = glyph_points(scene, number, input);
    std::set glyphs{static_cast<std::uint32_t>(std::ranges::max_element(points) - points.begin())};
    for (const Largest& at : largest)
        if (at.is_visible())
            glyphs.insert(at.glyph);
    return glyphs;
}

}

void put_texts(const LargestTexts& texts, OutlineMeter& meter)
{
    for (std::uint32_t number = 0; number < texts.size(); ++number)
        meter.put_text(number, texts[number]);
}

std::vector<LargestTexts> largest_texts(const SceneView& scene, std::span<const MeasuredMoment> moments,
                                        OutlineMeter& meter)
{
    const std::vector<MeasuredMoment> samples = samples_of(scene, moments);
    std::vector<LargestTexts> sets{LargestTexts(scene.input_count())};
    InputCursor inputs = scene.inputs();
    for (std::uint32_t number = 0; !inputs.at_end(); ++number) {
        const InputView input = inputs.next();
        if (input.type != InputType::text)
            continue;
        const auto glyphs = largest_glyphs(scene, number, input.text, samples, meter);
        if (glyphs.size() > sets.size())
            sets.resize(glyphs.size(), sets.back());
        auto glyph = glyphs.begin();
        for (LargestTexts& texts : sets) {
            texts[number] = full_text(input.text, *glyph);
            if (std::next(glyph) != glyphs.end())
                ++glyph;
        }
    }
    return sets;
}

}
