#include "host/fit/busy_inputs.hpp"

#include "host/walk/input_text.hpp"

#include <algorithm>

namespace kfast::fit {

BusyInputs::BusyInputs(SceneState& player) : player_{player}, texts_{long_texts(player.scene())}
{
    for (std::uint32_t input = 0; input < player.scene().input_count(); ++input)
        default_drawings_.push_back(is_drawing(input) ? received_drawing(player_.drawing(input))
                                                      : ReceivedDrawing{});
}

void BusyInputs::put(int frame)
{
    const std::int32_t there_and_back = 2 * whole_input.ticks;
    const std::int64_t step = there_and_back / turn;
    for (std::uint32_t input = 0; input < player_.scene().input_count(); ++input) {
        if (is_drawing(input)) {
            put_drawing(input, Bustle::waves, frame);
            continue;
        }
        if (!is_number(input))
            continue;
        const auto way = static_cast<std::int32_t>(frame * step * (input + 1) % there_and_back);
        player_.set_input(input, {std::min(way, there_and_back - way)});
    }
    put_texts(frame);
}

void BusyInputs::put_all(Time place)
{
    for (std::uint32_t input = 0; input < player_.scene().input_count(); ++input)
        if (is_drawing(input))
            put_drawing(input, Bustle::waves, place.ticks);
        else if (is_number(input))
            player_.set_input(input, place);
    put_texts(place == Time{} ? 0 : 1);
}

void BusyInputs::put_noise(int frame)
{
    for (std::uint32_t input = 0; input < player_.scene().input_count(); ++input)
        if (is_drawing(input))
            put_drawing(input, Bustle::noise, frame);
}

void BusyInputs::put_default()
{
    std::uint32_t number = 0;
    for (InputCursor inputs = player_.scene().inputs(); !inputs.at_end(); ++number) {
        const InputView input = inputs.next();
        if (input.type == InputType::number)
            player_.set_input(number, input.place_of(input.default_value));
        else if (input.type == InputType::drawing)
            player_.set_drawing(number, strokes_of(default_drawings_[number]));
    }
    for (const LongText& text : texts_)
        player_.set_text(text.input, text.default_text);
}

void BusyInputs::put_drawing(std::uint32_t input, Bustle bustle, int frame)
{
    player_.set_drawing(input, strokes_of(busy_drawing(player_.scene(), input, bustle, frame)));
}

void BusyInputs::put_texts(int frame)
{
    for (const LongText& text : texts_)
        player_.set_text(text.input, text.texts[static_cast<std::size_t>(frame) % text.texts.size()]);
}

std::vector<BusyInputs::LongText> BusyInputs::long_texts(const SceneView& scene)
{
    std::vector<LongText> texts;
    std::uint32_t number = 0;
    for (InputCursor inputs = scene.inputs(); !inputs.at_end(); ++number) {
        const InputView input = inputs.next();
        if (input.type != InputType::text)
            continue;
        const TextInput& text = input.text;
        std::vector<std::size_t> points = glyph_points(scene, number, text);
        const auto take_max = [&] {
            const auto max = std::ranges::max_element(points);
            *max = 0;
            return full_text(text, static_cast<std::uint32_t>(max - points.begin()));
        };
        const std::string first = take_max();
        texts.push_back({number, {first, take_max()}, default_text(text)});
    }
    return texts;
}

}
