#include "host/fit/busy_inputs.hpp"

#include "host/walk/input_text.hpp"

#include <algorithm>
#include <limits>
#include <random>

namespace kfast::fit {

namespace {

/// In 1/16 px.
struct Extent {
    int low = std::numeric_limits<int>::max();
    int high = std::numeric_limits<int>::min();

    void add(Fixed coordinate)
    {
        const int at = coordinate.raw() / (Fixed::one / 16);
        low = std::min(low, at);
        high = std::max(high, at);
    }
    Extent or_side(int pixels) const { return low < high ? *this : Extent{0, 16 * pixels}; }
    std::int16_t at(std::size_t part, std::size_t count) const
    {
        const auto way = static_cast<std::int64_t>(high - low) * static_cast<std::int64_t>(part);
        return static_cast<std::int16_t>(low +
                                         way / static_cast<std::int64_t>(std::max<std::size_t>(count, 1)));
    }
};

struct Box {
    Extent x;
    Extent y;

    void add(Point point)
    {
        x.add(point.x);
        y.add(point.y);
    }
};

Box box_of(const SceneView& scene, PackedDrawing drawing)
{
    Box box;
    for (std::uint32_t left = drawing.strokes(); left > 0; --left) {
        std::uint32_t segments = drawing.next_stroke();
        box.add(drawing.start());
        for (; segments > 0; --segments)
            box.add(drawing.next_segment().to);
    }
    return {box.x.or_side(scene.canvas().width), box.y.or_side(scene.canvas().height)};
}

/// Of one point after another, 0 … levels.
class Heights {
public:
    static constexpr std::size_t levels = 1000;

    Heights(Bustle bustle, int frame)
        : bustle_{bustle}, random_{static_cast<std::uint32_t>(frame)}, point_{static_cast<std::size_t>(frame)}
    {
    }

    std::size_t next()
    {
        if (bustle_ == Bustle::noise)
            return random_() % (levels + 1);
        const std::size_t phase = point_++ % wave;
        if (phase == 0)
            height_ = random_() % (levels + 1);
        return (levels - height_) / 2 + height_ * std::min(phase, wave - phase) / (wave / 2);
    }

private:
    static constexpr std::size_t wave = 8; ///< points

    Bustle bustle_;
    std::mt19937 random_;
    std::size_t point_;
    std::size_t height_ = levels / 2;
};

}

ReceivedDrawing busy_drawing(const SceneView& scene, std::uint32_t number, Bustle bustle, int frame)
{
    const DrawingInput limits = scene.input(number).drawing;
    const Box box = box_of(scene, scene.drawing(limits.default_value));
    Heights heights{bustle, frame};
    ReceivedDrawing drawing(limits.strokes);
    for (std::size_t point = 0; point < limits.points; ++point)
        drawing[point * limits.strokes / limits.points].push_back(
            {box.x.at(point, limits.points - 1), box.y.at(heights.next(), Heights::levels)});
    return drawing;
}

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
