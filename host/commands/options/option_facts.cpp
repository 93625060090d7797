#include "host/commands/options/option_facts.hpp"

#include <charconv>
#include <system_error>
#include <utility>

namespace kfast {

namespace {

/// The only thing that CLI11 keeps with an option for its callers is checks: so the facts are in one.
struct FactsCheck {
    CLI::Validator check;
    OptionFacts facts;

    std::string operator()(std::string& text) const { return check(text); }
};

/// Gives access to what a check runs.
struct OpenValidator : CLI::Validator {
    static const OptionFacts* facts_in(const CLI::Validator& check)
    {
        const auto* const held = (check.*&OpenValidator::func_).target<FactsCheck>();
        return held == nullptr ? nullptr : &held->facts;
    }
};

const CLI::Validator* check_of(const CLI::Option& option, int index)
{
    try {
        // This is the only access to a check by its index, and nothing is changed.
        return const_cast<CLI::Option&>(option).get_validator(index);
    } catch (const CLI::OptionNotFound&) {
        return nullptr;
    }
}

void join_facts(const OptionFacts& more, OptionFacts& all)
{
    if (more.kind != OptionKind::word) {
        all.kind = more.kind;
        all.range = more.range;
        all.endings = more.endings;
    }
    all.offered.insert(all.offered.end(), more.offered.begin(), more.offered.end());
}

CLI::Option* add_facts(CLI::Option* option, OptionFacts facts)
{
    return option->check(with_facts(CLI::Validator{}, std::move(facts)));
}

/// Without an exponent: "768000".
std::string bound_text(double bound)
{
    char digits[32];
    return {digits, std::to_chars(digits, std::end(digits), bound, std::chars_format::fixed).ptr};
}

}

OptionFacts option_facts(const CLI::Option& option)
{
    OptionFacts all;
    for (int i = 0; const CLI::Validator* check = check_of(option, i); ++i)
        if (const OptionFacts* const facts = OpenValidator::facts_in(*check))
            join_facts(*facts, all);
    return all;
}

CLI::Option* reads_file(CLI::Option* option, std::vector<std::string> endings)
{
    return add_facts(option, {.kind = OptionKind::file_to_read, .endings = std::move(endings)});
}

CLI::Option* writes_file(CLI::Option* option, std::vector<std::string> endings)
{
    return add_facts(option, {.kind = OptionKind::file_to_write, .endings = std::move(endings)});
}

CLI::Option* names_folder(CLI::Option* option, std::vector<std::string> endings)
{
    return add_facts(option, {.kind = OptionKind::folder, .endings = std::move(endings)});
}

CLI::Option* offer(CLI::Option* option, const std::vector<std::string_view>& words)
{
    return add_facts(option, {.offered = {words.begin(), words.end()}});
}

CLI::Validator with_facts(CLI::Validator check, OptionFacts facts)
{
    const std::string description = check.get_description();
    return {FactsCheck{std::move(check), std::move(facts)}, description};
}

CLI::Validator number_within(double min, double max)
{
    const std::string bounds = bound_text(min) + " to " + bound_text(max);
    const auto mistake = [=](const std::string& text) {
        double value = 0;
        const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_number = error == std::errc{} && rest == text.data() + text.size();
        return is_number && value >= min && value <= max ? ""
                                                         : "'" + text + "' is not a number from " + bounds;
    };
    return with_facts({mistake, bounds}, {.kind = OptionKind::number, .range = bounds});
}

}
