#include "host/commands/inputs/drawing_options.hpp"

#include "host/commands/inputs/input_names.hpp"
#include "host/commands/options/option_groups.hpp"
#include "host/file/input_file.hpp"
#include "host/player/drawing_text.hpp"
#include "host/text/counted.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

namespace kfast {
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

}
