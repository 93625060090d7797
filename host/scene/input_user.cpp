#include "host/scene/input_user.hpp"

#include "host/kdl/canonical.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"
#include "host/text/suggestion.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene {
namespace {

std::string_view noun(InputType type) { return type == InputType::drawing ? "a drawing" : "a number"; }

std::string example(std::string_view name, InputType type)
{
    const std::string input = "add \"input " + kdl::string_form(name);
    return input + (type == InputType::drawing ? " kind=drawing points=100" : " min=0 max=1") +
           "\" to the scene";
}

/// Those of the type.
std::vector<std::string_view> names(InputType type, const InputTable& inputs)
{
    std::vector<std::string_view> known;
    for (const InputEntry& entry : inputs.entries)
        if (entry.input.type == type)
            known.push_back(entry.input.name);
    return known;
}

}

std::optional<std::size_t> use_input(const kdl::Value& name, InputType type, Reading& reading)
{
    const auto text = read_name(name, reading);
    if (!text)
        return std::nullopt;
    InputTable& inputs = reading.inputs;
    InputEntry* const entry = inputs.find(*text);
    if (entry != nullptr && entry->input.type == type) {
        entry->is_used = true;
        return static_cast<std::size_t>(entry - inputs.entries.data());
    }
    if (entry != nullptr) {
        entry->is_used = true; // by mistake, which is enough to tell
        reading.report.error(name.place,
                             "the input " + quoted(*text) + " is " + std::string{noun(entry->input.type)} +
                                 ", not " + std::string{noun(type)},
                             type == InputType::number ? "keys go by numbers; live= shows a drawing"
                                                       : "input= takes a number");
        return std::nullopt;
    }
    const auto known = names(type, inputs);
    reading.report.error(name.place, "unknown input " + quoted(*text),
                         known.empty() ? example(*text, type) : suggestion(*text, known));
    return std::nullopt;
}

}
