#include "host/scene/values/input_user.hpp"

#include "host/kdl/canonical.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene {
namespace {

/// The words for the inputs of a type.
struct Wording {
    std::string_view noun;
    std::string_view declaration; ///< after the name
    std::string_view use;
};

Wording wording(InputType type)
{
    switch (type) {
    case InputType::number:
        break;
    case InputType::text:
        return {"a text", " kind=text glyphs=A-Z max=8", "a text is shown by 'text input=NAME'"};
    case InputType::drawing:
        return {"a drawing", " kind=drawing points=100", "live= shows a drawing"};
    }
    return {"a number", " min=0 max=1", "keys go by numbers"};
}

std::string example(std::string_view name, InputType type)
{
    return "add \"input " + kdl::string_form(name) + std::string{wording(type).declaration} +
           "\" to the scene";
}

/// The names of the inputs of the type.
std::vector<std::string_view> names(InputType type, const InputTable& inputs)
{
    std::vector<std::string_view> known;
    for (const InputEntry& entry : inputs.entries)
        if (entry.input.type == type)
            known.push_back(entry.input.name);
    return known;
}

}

std::optional<std::size_t> use_input(const kdl::Value& name, InputType type, SceneContext& context)
{
    const auto text = read_name(name, context.report);
    if (!text)
        return std::nullopt;
    InputTable& inputs = context.inputs;
    InputEntry* const entry = inputs.find(*text);
    if (entry != nullptr && entry->input.type == type) {
        entry->is_used = true;
        return static_cast<std::size_t>(entry - inputs.entries.data());
    }
    if (entry != nullptr) {
        entry->is_used = true; // by mistake, which is enough to report
        const Wording actual = wording(entry->input.type);
        context.report.error(name.place,
                             "the input " + in_quotes(*text) + " is " + std::string{actual.noun} + ", not " +
                                 std::string{wording(type).noun},
                             std::string{wording(type).use} + "; " + std::string{actual.use});
        return std::nullopt;
    }
    const auto known = names(type, inputs);
    context.report.error(name.place, "unknown input " + in_quotes(*text),
                         known.empty() ? example(*text, type) : suggestion(*text, known));
    return std::nullopt;
}

std::optional<std::size_t> use_label_input(const kdl::Value& name, SceneContext& context)
{
    const auto* const text = name.string();
    const InputEntry* const entry = text == nullptr ? nullptr : context.inputs.find(*text);
    const bool is_number = entry != nullptr && entry->input.type == InputType::number;
    return use_input(name, is_number ? InputType::number : InputType::text, context);
}

}
