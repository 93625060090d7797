#include "host/commands/inputs/input_options.hpp"

#include "host/commands/inputs/input_value.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/file/input_file.hpp"
#include "host/player/received_drawing.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/text/suggestion.hpp"
#include "host/walk/input_text.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

namespace kfast {

std::vector<std::string_view> input_names(const SceneView& scene, InputType type)
{
    std::vector<std::string_view> names;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();)
        if (const InputView input = inputs.next(); input.type == type)
            names.push_back(input.name);
    return names;
}

std::size_t end_of_input_name(std::string_view text, const SceneView& scene)
{
    std::size_t end = std::string_view::npos;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end();) {
        const std::string_view name = inputs.next().name;
        const bool fits = text.starts_with(name) && text.substr(name.size()).starts_with('=');
        if (fits && (end == std::string_view::npos || name.size() > end))
            end = name.size();
    }
    return end != std::string_view::npos ? end : text.rfind('=');
}

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

namespace {

namespace fs = std::filesystem;

constexpr InputKind drawing_text_file{"drawing", "a text with points",
                                      "a drawing begins with a point, like 10,20"};

[[noreturn]] void refuse_drawing(const std::string& message)
{
    throw CLI::ValidationError("--drawing", message);
}

std::size_t sign_in(const std::string& text, const SceneView& scene)
{
    const std::size_t sign = end_of_input_name(text, scene);
    if (sign == std::string::npos)
        refuse_drawing("'" + text + "' has no file: write it like plot=points.txt");
    return sign;
}

std::uint32_t drawing_input(std::string_view name, const SceneView& scene)
{
    const auto number = scene.input(name);
    if (number && scene.input(*number).type == InputType::drawing)
        return *number;
    const auto known = input_names(scene, InputType::drawing);
    refuse_drawing("there is no drawing '" + std::string{name} + "' among the inputs: " +
                   (known.empty() ? "the scene has none: leave out --drawing" : suggestion(name, known)));
}

ReceivedDrawing drawing_in(const std::string& file)
{
    auto read = read_drawing(read_input(file, drawing_text_file));
    if (const auto* const mistake = std::get_if<std::string>(&read))
        refuse_drawing(file + ": " + *mistake);
    return std::get<ReceivedDrawing>(std::move(read));
}

[[noreturn]] void refuse_size(const std::string& file, const InputView& input)
{
    refuse_drawing(file + ": the input '" + std::string{input.name} + "' takes at most " +
                   counted(input.drawing.points, "point") + " in " +
                   counted(input.drawing.strokes, "stroke"));
}

}

void declare_drawing_options(CLI::App& app, DrawingOptions& options)
{
    const OptionHeading heading{app, option_group::inputs};
    app.add_option("--drawing", options.texts,
                   "What a drawing among the inputs is told: a text like \"10,20 30,40 / 50,60\"; may be "
                   "repeated")
        ->type_name("NAME=FILE");
}

fs::path drawing_file(const std::string& text, const SceneView& scene)
{
    return text.substr(sign_in(text, scene) + 1);
}

void require_drawing(const std::string& text, const SceneView& scene)
{
    drawing_input(std::string_view{text}.substr(0, sign_in(text, scene)), scene);
}

std::vector<DrawingValue> chosen_drawings(const DrawingOptions& options, const SceneView& scene)
{
    std::vector<DrawingValue> drawings;
    for (const std::string& text : options.texts) {
        const std::size_t sign = sign_in(text, scene);
        const std::uint32_t number = drawing_input(std::string_view{text}.substr(0, sign), scene);
        const std::string file = text.substr(sign + 1);
        drawings.push_back({number, drawing_in(file), file});
    }
    return drawings;
}

void put_drawings(const std::vector<DrawingValue>& drawings, const SceneView& scene, InputReceiver& receiver)
{
    for (const DrawingValue& value : drawings)
        if (!receiver.set_drawing(value.number, strokes_of(value.drawing)))
            refuse_size(value.file, scene.input(value.number));
}

InputValues chosen_values(const InputOptions& inputs, const DrawingOptions& drawings, const SceneView& scene)
{
    return {chosen_inputs(inputs, scene), chosen_drawings(drawings, scene)};
}

void put_values(const InputValues& values, const SceneView& scene, InputReceiver& receiver)
{
    put_inputs(values.values, scene, receiver);
    put_drawings(values.drawings, scene, receiver);
}

}
