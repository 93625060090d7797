#include "host/commands/live_line.hpp"

#include "host/commands/input_value.hpp"
#include "host/drawing_text.hpp"
#include "host/failure.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>

namespace kfast {
namespace {

[[noreturn]] void refuse(std::size_t number, const std::string& why)
{
    throw Failure{"line " + std::to_string(number) + ": " + why};
}

constexpr std::string_view blanks = " \t\r";

/// Takes words off a line: up to a blank, or in quotes, where \" and \\ stand for what follows the \.
class Words {
public:
    Words(std::string_view line, std::size_t number) : rest_{line}, number_{number} { skip_blanks(); }

    bool at_end() const { return rest_.empty() || rest_.front() == '#'; }
    /// What has not been taken, without a comment.
    std::string_view rest() const { return rest_.substr(0, rest_.find('#')); }
    /// Only when not at the end.
    std::string next()
    {
        std::string word = rest_.front() == '"' ? quoted_word() : plain_word();
        skip_blanks();
        return word;
    }

private:
    void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size())); }

    std::string plain_word()
    {
        const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
        rest_.remove_prefix(word.size());
        return std::string{word};
    }

    std::string quoted_word()
    {
        std::string word;
        for (std::size_t at = 1; at < rest_.size(); ++at) {
            if (rest_[at] == '"') {
                rest_.remove_prefix(at + 1);
                return word;
            }
            if (rest_[at] == '\\' && at + 1 < rest_.size())
                ++at;
            word += rest_[at];
        }
        refuse(number_, "a \" is missing: the text of " + kfast::quoted(word) + " does not end");
    }

    std::string_view rest_;
    std::size_t number_;
};

std::size_t index_of(const std::string& name, std::size_t number, std::span<const LiveInput> inputs)
{
    const auto found = std::ranges::find(inputs, name, &LiveInput::name);
    if (found != inputs.end())
        return static_cast<std::size_t>(found - inputs.begin());
    std::vector<std::string_view> names;
    std::ranges::transform(inputs, std::back_inserter(names), &LiveInput::name);
    refuse(number, "there is no input '" + visible(name) + "': " + suggestion(name, names));
}

Time place_of(const std::string& value, const InputView& input, std::size_t number)
{
    const auto thousandths = read_input_value(value, input);
    if (!thousandths)
        refuse(number, input_value_mistake(value, input));
    return input.place_of(*thousandths);
}

}

std::optional<LiveDrawingLine> read_live_drawing(std::string_view line, std::size_t number,
                                                 std::span<const LiveInput> inputs)
{
    Words words{line, number};
    if (words.at_end())
        return std::nullopt;
    const auto found = std::ranges::find(inputs, words.next(), &LiveInput::name);
    if (found == inputs.end() || found->type != InputType::drawing)
        return std::nullopt;
    auto read = read_drawing(words.rest());
    if (const auto* const mistake = std::get_if<std::string>(&read))
        refuse(number, *mistake);
    return LiveDrawingLine{static_cast<std::uint8_t>(found - inputs.begin()),
                           std::get<ToldDrawing>(std::move(read))};
}

std::vector<link::InputPlace> read_live_line(std::string_view line, std::size_t number,
                                             std::span<const LiveInput> inputs)
{
    std::vector<link::InputPlace> places;
    for (Words words{line, number}; !words.at_end();) {
        const std::string name = words.next();
        const std::size_t index = index_of(name, number, inputs);
        if (inputs[index].type != InputType::number)
            refuse(number, "'" + visible(name) + "' is no number: a drawing has a line for itself");
        if (words.at_end())
            refuse(number, "'" + visible(name) + "' has no value: write it like gaze 0.5");
        places.push_back(
            {static_cast<std::uint8_t>(index), place_of(words.next(), inputs[index].view(), number)});
    }
    return places;
}

}
