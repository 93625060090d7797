#include "host/commands/live/live_line.hpp"

#include "firmware/link/input_message.hpp"
#include "firmware/link/message.hpp"
#include "host/commands/inputs/input_value.hpp"
#include "host/player/received_drawing.hpp"
#include "host/program/failure.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

namespace kfast {
namespace {

[[noreturn]] void refuse(std::size_t number, const std::string& why)
{
    throw Failure{"line " + std::to_string(number) + ": " + why};
}

constexpr std::string_view blanks = " \t\r";

/// Takes words off a line: up to a blank, or in quotes, where \" and \\ represent what follows the \.
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
        refuse(number_, "a \" is missing: the text of " + in_quotes(word) + " does not end");
    }

    std::string_view rest_;
    std::size_t number_;
};

/// Reads one line.
class LiveLine {
public:
    LiveLine(std::string_view line, std::size_t number, std::span<const LiveInput> inputs)
        : words_{line, number}, number_{number}, inputs_{inputs}
    {
    }

    LiveValues read()
    {
        for (bool is_first = true; !words_.at_end(); is_first = false) {
            const std::size_t index = index_of(words_.next());
            if (inputs_[index].type == InputType::drawing)
                return drawing(index, is_first);
            read_value(index);
        }
        return values_;
    }

private:
    std::size_t index_of(const std::string& name) const
    {
        const auto found = std::ranges::find(inputs_, name, &LiveInput::name);
        if (found != inputs_.end())
            return static_cast<std::size_t>(found - inputs_.begin());
        std::vector<std::string_view> names;
        std::ranges::transform(inputs_, std::back_inserter(names), &LiveInput::name);
        refuse(number_, "there is no input '" + visible(name) + "': " + suggestion(name, names));
    }

    /// All that is left of the line.
    LiveValues drawing(std::size_t index, bool is_first) const
    {
        if (!is_first)
            refuse(number_,
                   "'" + visible(inputs_[index].name) + "' is a drawing, which has a line for itself");
        auto read = read_drawing(words_.rest());
        if (const auto* const mistake = std::get_if<std::string>(&read))
            refuse(number_, *mistake);
        return {.drawings = {{static_cast<std::uint8_t>(index), std::get<ReceivedDrawing>(std::move(read))}}};
    }

    void read_value(std::size_t index)
    {
        const LiveInput& input = inputs_[index];
        const bool is_text = input.type == InputType::text;
        if (words_.at_end())
            refuse(number_, "'" + visible(input.name) + "' has no value: write it like " +
                                (is_text ? "label \"12:45\"" : "gaze 0.5"));
        const auto key = static_cast<std::uint8_t>(index);
        if (is_text)
            values_.texts[key] = text(words_.next(), input);
        else
            values_.places[key] = place(words_.next(), input.view());
    }

    Time place(const std::string& value, const InputView& input) const
    {
        const auto thousandths = read_input_value(value, input);
        if (!thousandths)
            refuse(number_, input_value_mistake(value, input));
        return input.place_of(*thousandths);
    }

    std::string text(const std::string& value, const LiveInput& input) const
    {
        const auto max = static_cast<std::size_t>(input.max);
        if (const auto mistake = input_text_mistake(value, input.name, max, input.glyphs))
            refuse(number_, *mistake);
        if (value.size() > link::Text::max)
            refuse(number_, "'" + visible(value) + "' is too long: a device is told at most " +
                                std::to_string(link::Text::max) + " bytes");
        return value;
    }

    Words words_;
    std::size_t number_;
    std::span<const LiveInput> inputs_;
    LiveValues values_;
};

}

LiveValues read_live_line(std::string_view line, std::size_t number, std::span<const LiveInput> inputs)
{
    return LiveLine{line, number, inputs}.read();
}

}
