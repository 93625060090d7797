#include "host/commands/help/man_page.hpp"

#include "firmware/version.hpp"
#include "host/commands/help/schema_lists.hpp"
#include "host/program/failure.hpp"
#include "host/scene/values/value_reader.hpp"

#include <cmath>
#include <set>
#include <sstream>
#include <string_view>

namespace kfast {
namespace {

/// The text for roff: hyphens that can be typed, and no letter that is a command (groff_char(7), groff(7)).
std::string plain(std::string_view text)
{
    std::string escaped;
    for (const char letter : text) {
        const bool begins_line = escaped.empty() || escaped.back() == '\n';
        if (begins_line && (letter == '.' || letter == '\''))
            escaped += "\\&";
        if (letter == '\\')
            escaped += "\\e";
        else if (letter == '-')
            escaped += "\\-";
        else if (letter == '\'')
            escaped += "\\(aq";
        else if (letter == '"')
            escaped += "\\(dq";
        else if (letter == '~')
            escaped += "\\(ti";
        else
            escaped += letter;
    }
    return escaped;
}

std::string bold(std::string_view text) { return "\\fB" + plain(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + plain(text) + "\\fR"; }

std::string upper(std::string text)
{
    for (char& letter : text)
        if (letter >= 'a' && letter <= 'z')
            letter = static_cast<char>(letter - 'a' + 'A');
    return text;
}

std::string page_name(const std::string& command)
{
    std::string name = "kfast" + (command.empty() ? "" : '-' + command);
    for (char& letter : name)
        if (letter == ' ')
            letter = '-';
    return name;
}

std::string head(const std::string& name, const char* section, const std::string& summary)
{
    return ".TH " + upper(name) + ' ' + section + " \"\" \"kfast " + std::string{version} +
           "\" \"KFAST\"\n.SH NAME\n" + plain(name) + " \\- " + plain(summary) + '\n';
}

std::string term(const std::string& term, const std::string& text)
{
    return ".TP\n" + term + '\n' + text + '\n';
}

std::string term_of(const OptionWords& option)
{
    if (option.is_positional)
        return italic(option.names.front());
    std::string names;
    for (const std::string& name : option.names)
        names.append(names.empty() ? "" : ", ").append(bold(name));
    return option.takes_value ? names + ' ' + italic(option.type) : names;
}

std::string synopsis(const CommandWords& command)
{
    std::string text = ".SH SYNOPSIS\n" + bold("kfast" + (command.name.empty() ? "" : ' ' + command.name));
    if (!command.subcommands.empty())
        return text + ' ' + italic("COMMAND") + " [" + italic("OPTIONS") + "]\n";
    text += " [" + italic("OPTIONS") + ']';
    for (const OptionWords& option : command.options)
        if (option.is_positional) {
            const std::string name = italic(option.names.front()) + (option.takes_many ? " ..." : "");
            text += option.is_required ? ' ' + name : " [" + name + ']';
        }
    return text + '\n';
}

std::string section_of(const CommandWords& command, const std::string& title, auto is_in)
{
    std::string terms;
    for (const OptionWords& option : command.options)
        if (is_in(option))
            terms += term(term_of(option), plain(whole_help(option)));
    return terms.empty() ? "" : ".SH " + title + '\n' + terms;
}

std::string options_sections(const CommandWords& command)
{
    std::string text =
        section_of(command, "ARGUMENTS", [](const OptionWords& option) { return option.is_positional; });
    std::set<std::string> groups;
    for (const OptionWords& option : command.options)
        if (!option.is_positional && groups.insert(option.group).second)
            text +=
                section_of(command, option.group == "Options" ? "OPTIONS" : '"' + plain(option.group) + '"',
                           [&](const OptionWords& other) {
                               return !other.is_positional && other.group == option.group;
                           });
    return text;
}

/// What the help shows after "Example:".
std::string examples_of(const CommandWords& command)
{
    const std::size_t begin = command.footer.find("Example:\n");
    if (begin == std::string::npos)
        return "";
    std::istringstream lines{command.footer.substr(begin + std::string_view{"Example:\n"}.size())};
    std::string text = ".SH EXAMPLES\n.nf\n";
    for (std::string line; std::getline(lines, line) && line.starts_with("  ");)
        text += plain(line.substr(2)) + '\n';
    return text + ".fi\n";
}

std::string reference(const std::string& name, const char* section)
{
    return bold(name) + '(' + section + ')';
}

std::string commands_of(const CommandWords& command)
{
    std::string text;
    std::set<std::string> groups;
    for (const CommandWords& other : command.subcommands)
        if (groups.insert(other.group).second) {
            text += ".SS " + plain(other.group) + '\n';
            for (const CommandWords& inner : command.subcommands)
                if (inner.group == other.group)
                    text += term(reference(page_name(inner.name), "1"), plain(inner.summary));
        }
    return text.empty() ? "" : ".SH COMMANDS\n" + text;
}

std::string exit_status()
{
    std::string text = ".SH EXIT STATUS\n";
    for (const auto& [status, meaning] : exit_meanings)
        text += term(bold(std::to_string(static_cast<int>(status))), plain(meaning));
    return text;
}

ManPage page_of(const CommandWords& command)
{
    const std::string name = page_name(command.name);
    std::string text = head(name, "1", command.summary) + synopsis(command) + commands_of(command) +
                       options_sections(command) + examples_of(command);
    text += command.name.empty() ? exit_status() : "";
    text += ".SH SEE ALSO\n" + (command.name.empty() ? "" : reference("kfast", "1") + ", ") +
            reference("kfast-scene", "5") + '\n';
    return {name + ".1", text};
}

void add_pages(const CommandWords& command, std::vector<ManPage>& pages)
{
    pages.push_back(page_of(command));
    for (const CommandWords& inner : command.subcommands)
        add_pages(inner, pages);
}

std::string range_text(const schema::ValueKind& kind)
{
    if (kind.type == schema::ValueType::word) {
        std::string text;
        for (const std::string_view word : kind.words)
            text.append(text.empty() ? "" : ", ").append(word);
        return text;
    }
    std::string text{type_name(kind.type)};
    if (std::isfinite(kind.range.high))
        text += ", " + scene::text_of(kind.range.low) + " to " + scene::text_of(kind.range.high);
    return kind.unit.empty() ? text : text + ' ' + std::string{kind.unit};
}

std::string text_of(const schema::NodeSchema& node, const scene::LanguageSchema& words)
{
    std::string text = "Stands in";
    for (const std::string_view id : holders(words, node.id))
        text += ' ' + std::string{id.empty() ? "the outermost level" : id} + ',';
    text.back() = '.';
    text = plain(text) + '\n';
    if (node.properties.empty() && !node.any_property)
        return text;
    text += ".RS\n";
    if (node.any_property)
        text += ".PP\nAny name: " + plain(range_text(*node.any_property)) + '\n';
    for (const schema::PropertySchema& property : node.properties)
        text += ".PP\n" + bold(property.name) + ": " + plain(range_text(property.kind)) +
                (property.required ? " (needed)" : "") + '\n';
    return text + ".RE\n";
}

ManPage scene_page(const scene::LanguageSchema& words)
{
    std::string text = head("kfast-scene", "5", "what a scene of kfast may be written with");
    text +=
        ".SH DESCRIPTION\nA scene is a KDL 2.0 document, a file that ends with " + bold(".kfast") +
        ". These are its nodes and their properties. What they mean is told in docs/scene\\-language.md.\n"
        ".SH NODES\n";
    for (const schema::NodeSchema& node : words.nodes)
        text += term(bold(node.form.usage), text_of(node, words));
    const auto list = [&text](const char* title, const std::vector<std::string_view>& entries) {
        text += std::string{".SH "} + title + '\n';
        for (const std::string_view entry : entries)
            text += term(bold(entry), "\\&");
    };
    list("LAWS", words.laws);
    text += ".SH SEE ALSO\n" + reference("kfast", "1") + ", " + reference("kfast-check", "1") + '\n';
    return {"kfast-scene.5", text};
}

}

std::vector<ManPage> man_pages(const CommandWords& kfast, const scene::LanguageSchema& words)
{
    std::vector<ManPage> pages;
    add_pages(kfast, pages);
    pages.push_back(scene_page(words));
    return pages;
}

}
