#include "host/commands/help/old_names.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <ostream>
#include <utility>

namespace kfast {
namespace {

constexpr std::array renamed_options{
    OldName{"check", "--format", "--json", "json"},
    OldName{"check", "--format", "", "text"}, // the default by now
    OldName{"check", "--name", "--stdin-filename"},
    OldName{"check", "--size", "--canvas"},
    OldName{"compile", "--size", "--canvas"},
    OldName{"export", "--invert", "--mirror"},
    OldName{"export", "--name", "--array-name"},
    OldName{"export", "--rate", "--sample-rate"},
    OldName{"fit", "--size", "--canvas"},
    OldName{"flash", "--serial", "--device"},
    OldName{"hash", "--fit", "--scaling"},
    OldName{"import", "--size", "--canvas"},
    OldName{"info", "--rate", "--point-rate"},
    OldName{"preview", "--fit", "--scaling"},
    OldName{"preview", "--invert", "--mirror"},
    OldName{"preview", "--keys", "--press"},
    OldName{"preview", "--rate", "--sample-rate"},
    OldName{"render", "--fit", "--scaling"},
    OldName{"simulate", "--flash", "--flash-file"},
    OldName{"simulate", "--frames", "--print-frames"},
};

std::string written(const OldName& name)
{
    return std::string{name.before} + (name.value.empty() ? "" : ' ' + std::string{name.value});
}

/// The rest of a command line, which is turned into what it says in the words of now.
class Renaming {
public:
    Renaming(std::span<const char* const> arguments, std::string_view command, std::ostream& notes)
        : rest_{arguments}, command_{command}, notes_{notes}
    {
    }

    std::vector<std::string> run()
    {
        while (!rest_.empty()) {
            const std::string_view word = rest_.front();
            if (word == "--")
                break;
            rest_ = rest_.subspan(1);
            if (auto now = word_of_now(word))
                renamed_.push_back(*std::move(now));
        }
        renamed_.insert(renamed_.end(), rest_.begin(), rest_.end());
        return renamed_;
    }

private:
    /// None for an option that is not needed any more.
    std::optional<std::string> word_of_now(std::string_view word)
    {
        const std::size_t sign = std::min(word.find('='), word.size());
        const std::string_view assigned = word.substr(sign); // "=json", or nothing
        const auto* const row = std::ranges::find_if(renamed_options, [&](const OldName& name) {
            return name.command == command_ && name.before == word.substr(0, sign) &&
                   (name.value.empty() || name.value == value_behind(assigned));
        });
        if (row == renamed_options.end())
            return std::string{word};
        if (!row->value.empty() && assigned.empty())
            rest_ = rest_.subspan(1); // the value goes with the option
        note(*row);
        if (row->now.empty())
            return std::nullopt;
        return std::string{row->now} + std::string{row->value.empty() ? assigned : ""};
    }

    std::string_view value_behind(std::string_view assigned) const
    {
        if (!assigned.empty())
            return assigned.substr(1);
        return rest_.empty() ? "" : rest_.front();
    }

    void note(const OldName& name) const
    {
        notes_ << "kfast: " << written(name);
        if (name.now.empty())
            notes_ << " is the default; the next version drops the option\n";
        else
            notes_ << " is now called " << name.now << "; the next version drops the old name\n";
    }

    std::span<const char* const> rest_;
    std::string_view command_;
    std::ostream& notes_;
    std::vector<std::string> renamed_ = {};
};

}

std::span<const OldName> old_names() { return renamed_options; }

std::vector<std::string> with_names_of_now(std::span<const char* const> arguments, std::ostream& notes)
{
    return Renaming{arguments, arguments.size() > 1 ? arguments[1] : "", notes}.run();
}

}
