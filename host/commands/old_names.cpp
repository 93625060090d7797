#include "host/commands/old_names.hpp"

#include <algorithm>
#include <array>
#include <ostream>

namespace kfast {
namespace {

constexpr std::array renamed_options{
    OldName{"check", "--format", "--json", "json"},
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
            renamed_.push_back(name_of_now(word));
        }
        renamed_.insert(renamed_.end(), rest_.begin(), rest_.end());
        return renamed_;
    }

private:
    std::string name_of_now(std::string_view word)
    {
        const std::size_t sign = std::min(word.find('='), word.size());
        const auto* const row = std::ranges::find_if(renamed_options, [&](const OldName& name) {
            return name.command == command_ && name.before == word.substr(0, sign);
        });
        if (row == renamed_options.end() || !has_value_of(*row, word.substr(sign)))
            return std::string{word};
        note(*row);
        return std::string{row->now} + std::string{row->value.empty() ? word.substr(sign) : ""};
    }

    /// `assigned` is "=json" or nothing; then the value is the next word, which goes with the option.
    bool has_value_of(const OldName& name, std::string_view assigned)
    {
        if (name.value.empty())
            return true;
        if (!assigned.empty())
            return assigned.substr(1) == name.value;
        if (rest_.empty() || rest_.front() != name.value)
            return false;
        rest_ = rest_.subspan(1);
        return true;
    }

    void note(const OldName& name) const
    {
        notes_ << "kfast: " << written(name) << " is now called " << name.now
               << "; the old name goes with the next version\n";
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
