#include "host/commands/help/law_page.hpp"

#include "core/features.hpp"
#include "host/scene/values/law_calls.hpp"
#include "host/words/easing_names.hpp"
#include "host/words/law_words.hpp"
#include "host/words/scene_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace kfast {
namespace {

constexpr std::size_t plain_width = 80; ///< where no terminal has one
constexpr std::size_t gap = 2;

/// A picture in letters of Braille, each of 2 x 4 dots.
class Dots {
public:
    static constexpr int columns = 24;
    static constexpr int rows = 6;
    static constexpr int width = 2 * columns;
    static constexpr int height = 4 * rows;

    void set(int x, int y)
    {
        letters_[static_cast<std::size_t>(y / 4)][static_cast<std::size_t>(x / 2)] |= bit_of(x % 2, y % 4);
    }
    std::string row(std::size_t number) const
    {
        std::string text;
        for (const unsigned dots : letters_[number]) // U+2800 and its 256 letters in UTF-8
            text += {'\xE2', static_cast<char>(0xA0 | dots >> 6), static_cast<char>(0x80 | (dots & 0x3F))};
        return text;
    }

private:
    static unsigned bit_of(int x, int y) { return y == 3 ? 0x40U << x : 1U << (3 * x + y); }

    std::array<std::array<unsigned, columns>, rows> letters_{};
};

/// The curve, and a dotted line at either key. From the bottom to the top the progress is that from 0.4
/// behind the earlier key to 0.4 beyond the next one.
Dots curve_of(const VelocityLaw& law)
{
    const auto height_of = [](double share) {
        return static_cast<int>(std::lround((1.4 - share) / 1.8 * (Dots::height - 1)));
    };
    Dots dots;
    for (int x = 0; x < Dots::width; x += 4) {
        dots.set(x, height_of(0));
        dots.set(x, height_of(1));
    }
    int before = height_of(0);
    for (int x = 0; x < Dots::width; ++x) {
        const auto time = static_cast<std::uint32_t>(x) * Fraction::one / (Dots::width - 1);
        const double share = progress(law, {time}, &kfast_springs).raw / double{Progress::one};
        const int y = std::clamp(height_of(share), 0, Dots::height - 1);
        const int step = y < before ? 1 : -1; // what is steep has no holes
        for (int between = y; between != before; between += step)
            dots.set(x, between);
        dots.set(x, y);
        before = y;
    }
    return dots;
}

/// With its default numbers, or with some that show what it does.
VelocityLaw example_of(const LawWord& word)
{
    if (!word.has_numbers())
        return word.law;
    const scene::CallForm& call = scene::call_of(word.keyword);
    if (call.has_default_numbers())
        return call.default_law();
    return word.law.kind == VelocityLaw::Kind::steps ? VelocityLaw::in_steps(4)
                                                     : bezier_law(0.8, -0.4, 0.2, 1.4);
}

void append_padded(std::string& line, std::string_view text, std::size_t letters)
{
    line.append(text).append(Dots::columns + gap - letters, ' ');
}

std::string without_end_spaces(std::string line) { return line.erase(line.find_last_not_of(' ') + 1) + '\n'; }

/// Some curves beside each other, below their names.
std::string row_of_curves(std::span<const LawWord> words)
{
    std::string line;
    for (const LawWord& word : words)
        append_padded(line, word.form, word.form.size());
    std::string text = without_end_spaces(line);
    std::vector<Dots> curves;
    for (const LawWord& word : words)
        curves.push_back(curve_of(example_of(word)));
    for (std::size_t row = 0; row < Dots::rows; ++row) {
        line.clear();
        for (const Dots& curve : curves)
            append_padded(line, curve.row(row), Dots::columns);
        text += without_end_spaces(line);
    }
    return text;
}

std::string default_numbers()
{
    std::string text;
    for (const LawWord& word : law_words)
        if (word.has_numbers() && scene::call_of(word.keyword).has_default_numbers()) {
            text.append(text.empty() ? "" : ", ").append(word.keyword).append(" is ").append(word.keyword);
            std::string numbers;
            for (const scene::Parameter& parameter : scene::call_of(word.keyword).parameters)
                numbers.append(numbers.empty() ? "(" : ",").append(scene::text_of(*parameter.default_value));
            text += numbers + ')';
        }
    return text;
}

}

std::string law_page(const HelpStyle& style)
{
    const std::size_t width = style.width == 0 ? plain_width : style.width;
    const std::size_t in_row = std::max<std::size_t>(1, (width + gap) / (Dots::columns + gap));
    std::string text =
        broken_text(
            "The velocity laws: how the way goes from a key, at the left end of each curve, to the next "
            "one. Written law=bounce, or with numbers law=\"bounce(2)\".",
            0, width) +
        '\n';
    const std::span words{law_words};
    for (std::size_t first = 0; first < words.size(); first += in_row)
        text += '\n' + row_of_curves(words.subspan(first, std::min(in_row, words.size() - first)));
    text += '\n' + broken_text("Without numbers " + default_numbers() + ".", 0, width) + "\n\n" +
            help_heading("Other names, also in the way of easeInQuad", style);
    for (const EasingName& easing : easing_names()) {
        std::string line = "  " + std::string{easing.name};
        line.append(24 - line.size(), ' ');
        text += line + std::string{easing.law} + '\n';
    }
    return text;
}

}
