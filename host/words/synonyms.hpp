#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kfast {

/// The hint for `word`, which is none of `known`, the words of the language that may be in its place. It
/// names the one that means what `word` does in CSS, SVG or another program ("KFAST calls it "rotate""), or
/// the page about what the language lacks (docs/scene-language.md#not-there); else as suggestion().
std::string word_hint(std::string_view word, std::span<const std::string_view> known);

struct Synonym {
    std::string_view word; ///< in small letters, parts joined by "-"
    std::string_view meaning;
};

/// The words of other programs. Of several meanings the first counts that may be in the place of the word.
std::span<const Synonym> synonyms();

/// The one of `known` that means what `word` does in CSS, SVG or another program; empty: there is none.
std::string_view meaning_among(std::span<const std::string_view> known, std::string_view word);

/// "strokeWidth" and "stroke_width" as "stroke-width".
std::string plain_word(std::string_view word);

/// What word_hint() says of a thing that the language lacks; empty if `word` is no name of one.
std::string hint_of_absent(std::string_view word);

}
