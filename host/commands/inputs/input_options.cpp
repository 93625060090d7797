#include "host/commands/inputs/input_options.hpp"

#include "host/commands/inputs/input_names.hpp"
#include "host/commands/inputs/input_value.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"
#include "host/walk/input_text.hpp"

#include <algorithm>
#include <string_view>

namespace kfast {
namespace {

std::vector<InputView> inputs_of(const SceneView& scene)
{
    std::vector<InputView> inputs;
    for (InputCursor cursor = scene.inputs(); !cursor.at_end();)
        inputs.push_back(cursor.next());
    return inputs;
}

[[noreturn]] void refuse_input(const std::string& message) { throw CLI::ValidationError("--input", message); }

[[noreturn]] void refuse_name(std::string_view name, const std::vector<InputView>& inputs)
{
    std::vector<std::string_view> names;
    for (const InputView& input : inputs)
        if (input.type != InputType::drawing)
            names.push_back(input.name);
    refuse_input("there is no input '" + std::string{name} +
                 "': " + (names.empty() ? "the scene has none: leave out --input" : suggestion(name, names)));
}

std::size_t sign_in(std::string_view text, const SceneView& scene)
{
    const std::size_t sign = end_of_input_name(text, scene);
    if (sign == std::string_view::npos)
        refuse_input("'" + std::string{text} + "' has no value: write it like gaze=0.5");
    return sign;
}

/// The place among `inputs` of the one whose name ends at `sign`.
std::size_t input_in(std::string_view text, std::size_t sign, const std::vector<InputView>& inputs)
{
    const auto input = std::ranges::find(inputs, text.substr(0, sign), &InputView::name);
    if (input == inputs.end())
        refuse_name(text.substr(0, sign), inputs);
    return static_cast<std::size_t>(input - inputs.begin());
}

std::int32_t read_number(std::string_view text, const InputView& input)
{
    const auto value = read_input_value(text, input);
    if (!value)
        refuse_input(input_value_mistake(text, input));
    return *value;
}

std::string read_text(std::string_view text, const InputView& input)
{
    if (const auto mistake = input_text_mistake(text, input.name, input.text.max, input.text.glyphs))
        refuse_input(*mistake);
    return std::string{text};
}

InputValue read_value(std::string_view text, const InputView& input)
{
    switch (input.type) {
    case InputType::number:
        return {.number = read_number(text, input)};
    case InputType::text:
        return {.text = read_text(text, input)};
    case InputType::drawing:
        break;
    }
    refuse_input("'" + std::string{input.name} + "' is a drawing: write --drawing " +
                 std::string{input.name} + "=FILE");
}

InputValue default_value(const InputView& input)
{
    if (input.type == InputType::text)
        return {.text = default_text(input.text)};
    return {.number = input.default_value};
}

}

void declare_input_options(CLI::App& app, InputOptions& options)
{
    const OptionHeading heading{app, option_group::inputs};
    app.add_option("--input", options.texts, "What an input of the scene is; may be repeated")
        ->type_name("NAME=VALUE");
}

void require_input(const std::string& text, const SceneView& scene)
{
    const std::vector<InputView> inputs = inputs_of(scene);
    input_in(text, sign_in(text, scene), inputs);
}

std::vector<InputValue> chosen_inputs(const InputOptions& options, const SceneView& scene)
{
    const std::vector<InputView> inputs = inputs_of(scene);
    std::vector<InputValue> values;
    std::ranges::transform(inputs, std::back_inserter(values), default_value);
    for (const std::string_view text : options.texts) {
        const std::size_t sign = sign_in(text, scene);
        const std::size_t input = input_in(text, sign, inputs);
        values[input] = read_value(text.substr(sign + 1), inputs[input]);
    }
    return values;
}

void put_inputs(const std::vector<InputValue>& values, const SceneView& scene, InputReceiver& receiver)
{
    std::uint32_t number = 0;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end(); ++number) {
        const InputView input = inputs.next();
        if (input.type == InputType::text)
            receiver.set_text(number, values[number].text);
        else if (input.type == InputType::number)
            receiver.set_input(number, input.place_of(values[number].number));
    }
}

}
