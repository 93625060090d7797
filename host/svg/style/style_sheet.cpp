#include "host/svg/style/style_sheet.hpp"

#include "host/program/failure.hpp"
#include "host/svg/markup/length.hpp"
#include "host/svg/markup/svg_text.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace kfast::svg {
namespace {

constexpr int most_specific = 1'000'000'000;
constexpr std::size_t max_rules = 10'000;
// Of matching; what is allowed takes about a second.
constexpr std::size_t compound_cost = 16;
constexpr std::size_t attribute_cost = 8;
constexpr std::size_t max_cost = std::size_t{1} << 29;

std::string without_comments(std::string_view css)
{
    std::string result;
    while (!css.empty()) {
        const std::size_t begin = css.find("/*");
        result.append(css.substr(0, begin));
        const std::size_t end = begin == css.npos ? css.npos : css.find("*/", begin + 2);
        css = end == css.npos ? std::string_view{} : css.substr(end + 2);
    }
    return result;
}

/// The parts between `separator`s that are in no parentheses and no quotes.
std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    std::size_t begin = 0;
    int depth = 0;
    char quote = '\0';
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char letter = text[i];
        if (quote != '\0')
            quote = letter == quote ? '\0' : quote;
        else if (letter == '"' || letter == '\'')
            quote = letter;
        else if (letter == '(')
            ++depth;
        else if (letter == ')')
            --depth;
        else if (letter == separator && depth <= 0) {
            parts.push_back(text.substr(begin, i - begin));
            begin = i + 1;
        }
    }
    parts.push_back(text.substr(std::min(begin, text.size())));
    return parts;
}

bool is_word_letter(char letter)
{
    const auto byte = static_cast<unsigned char>(letter);
    return std::isalnum(byte) != 0 || letter == '-' || letter == '_' || byte >= 0x80;
}

/// A name, in which a backslash takes the letter after it literally.
std::string take_word(std::string_view& text)
{
    std::string word;
    while (!text.empty() && (is_word_letter(text.front()) || (text.front() == '\\' && text.size() > 1))) {
        if (text.front() == '\\')
            text.remove_prefix(1);
        word += text.front();
        text.remove_prefix(1);
    }
    return word;
}

/// Takes a compound off the text; nothing if there is none, or if it has brackets or colons.
std::optional<Compound> take_compound(std::string_view& text)
{
    Compound compound;
    const std::size_t size = text.size();
    constexpr std::string_view outermost = ":root";
    if (text.starts_with('*')) {
        text.remove_prefix(1);
    } else if (text.starts_with(outermost)) {
        compound.type = "svg";
        text.remove_prefix(outermost.size());
    } else {
        compound.type = take_word(text);
    }
    while (!text.empty() && (text.front() == '.' || text.front() == '#')) {
        const bool is_class = text.front() == '.';
        text.remove_prefix(1);
        (is_class ? compound.classes : compound.ids).push_back(take_word(text));
    }
    if (text.size() == size || text.starts_with('[') || text.starts_with(':'))
        return std::nullopt;
    return compound;
}

int specificity(const Compound& compound)
{
    constexpr std::size_t max = 99; // of a kind: the next one outweighs them all
    return static_cast<int>(10'000 * std::min(compound.ids.size(), max) +
                            100 * std::min(compound.classes.size(), max)) +
           (compound.type.empty() ? 0 : 1);
}

std::optional<Selector> selector(std::string_view text)
{
    Selector result;
    std::vector<Selector::Outer> from_outside;
    for (text = trimmed(text); !text.empty();) {
        const auto compound = take_compound(text);
        if (!compound)
            return std::nullopt;
        result.specificity = std::min(result.specificity + specificity(*compound), most_specific);
        text = trimmed(text);
        const bool is_parent = text.starts_with('>');
        if (is_parent)
            text = trimmed(text.substr(1));
        from_outside.push_back({*compound, is_parent});
    }
    if (from_outside.empty() || from_outside.back().is_parent)
        return std::nullopt;
    result.compound = std::move(from_outside.back().compound);
    from_outside.pop_back();
    result.around.assign(from_outside.rbegin(), from_outside.rend());
    return result;
}

/// At worst, where each of the words begins with `word`.
std::size_t search_cost(std::string_view words, std::string_view word)
{
    return 8 + words.size() / 64 + words.size() * word.size() / 256;
}

/// Whether `word` is one of those words that spaces separate.
bool has_word(std::string_view words, std::string_view word)
{
    const auto is_space = [](char letter) { return std::isspace(static_cast<unsigned char>(letter)) != 0; };
    for (std::size_t at = words.find(word); at != words.npos; at = words.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || is_space(words[at - 1])) && (end == words.size() || is_space(words[end])))
            return true;
    }
    return false;
}

bool matches(const Compound& compound, const StyledElement& element, std::size_t& cost)
{
    cost += compound_cost + element.name.size() / 64;
    if (!compound.type.empty() && element.name != compound.type)
        return false;
    if (!std::ranges::all_of(compound.ids, [&](const std::string& id) {
            cost += element.id.size() == id.size() ? 1 + id.size() / 64 : 1;
            return element.id == id;
        }))
        return false;
    return std::ranges::all_of(compound.classes, [&](const std::string& name) {
        cost += search_cost(element.classes, name);
        return has_word(element.classes, name);
    });
}

StyledElement styled(pugi::xml_node element, std::size_t& cost)
{
    StyledElement result{.name = element_name(element), .id = {}, .classes = {}};
    for (const pugi::xml_attribute attribute : element.attributes()) {
        cost += attribute_cost;
        const std::string_view name = attribute.name();
        if (name == "id" && result.id.empty())
            result.id = attribute.value();
        else if (name == "class" && result.classes.empty())
            result.classes = attribute.value();
    }
    cost += (result.name.size() + result.id.size() + result.classes.size()) / 64;
    return result;
}

/// The element and those around it, from the inside to the outside.
std::vector<StyledElement> path_of(pugi::xml_node element, std::size_t& cost)
{
    std::vector<StyledElement> path;
    for (; element.type() == pugi::node_element; element = element.parent()) {
        cost += compound_cost;
        path.push_back(styled(element, cost));
    }
    return path;
}

struct StyleFinder : pugi::xml_tree_walker {
    bool for_each(pugi::xml_node& node) override
    {
        const std::string_view type = node.attribute("type").value();
        if (element_name(node) == "style" && (type.empty() || type == "text/css"))
            found.push_back(node);
        return true;
    }
    std::vector<pugi::xml_node> found;
};

using Around = std::vector<Selector::Outer>::const_iterator;

/// `around` lie around what has matched so far, from the inside to the outside.
bool matches_around(Around outer, Around end, std::span<const StyledElement> around, int& tries,
                    std::size_t& cost)
{
    if (outer == end)
        return true;
    for (; !around.empty(); around = around.subspan(1)) {
        if (--tries < 0)
            return false;
        if (matches(outer->compound, around.front(), cost) &&
            matches_around(outer + 1, end, around.subspan(1), tries, cost))
            return true;
        if (outer->is_parent)
            return false;
    }
    return false;
}

}

bool Selector::matches(std::span<const StyledElement> path, std::size_t& cost) const
{
    int tries = 1000; // many nested descendants would try all combinations
    return svg::matches(compound, path.front(), cost) &&
           matches_around(around.begin(), around.end(), path.subspan(1), tries, cost);
}

std::vector<Declaration> declarations(std::string_view text)
{
    std::vector<Declaration> result;
    const std::string plain = without_comments(text);
    for (const std::string_view part : split(plain, ';')) {
        const std::size_t colon = part.find(':');
        if (colon == part.npos)
            continue;
        std::string_view value = trimmed(part.substr(colon + 1));
        const std::size_t mark = value.rfind('!');
        const bool important = mark != value.npos && trimmed(value.substr(mark + 1)) == "important";
        if (important)
            value = trimmed(value.substr(0, mark));
        result.push_back({std::string{trimmed(part.substr(0, colon))}, std::string{value}, important});
    }
    return result;
}

void StyleSheet::add_elements(pugi::xml_node root, art::Losses& losses)
{
    StyleFinder finder;
    root.traverse(finder);
    for (const pugi::xml_node element : finder.found) {
        std::string css;
        for (const auto child : element.children())
            css += child.value();
        add(css, 0, losses);
    }
    std::ranges::stable_sort(rules_, {}, [](const Rule& rule) { return rule.selector.specificity; });
}

void StyleSheet::add(std::string_view css, int depth, art::Losses& losses)
{
    const std::string plain = without_comments(css);
    std::string_view rest = trimmed(plain);
    while (!rest.empty()) {
        const std::size_t stop = rest.find_first_of("{;");
        if (stop == rest.npos)
            return;
        const std::string_view prelude = trimmed(rest.substr(0, stop));
        if (rest[stop] == ';') {
            add_at_rule(prelude, {}, depth, losses);
            rest = trimmed(rest.substr(stop + 1));
            continue;
        }
        std::size_t end = stop + 1;
        for (int open = 1; end < rest.size(); ++end) {
            open += rest[end] == '{' ? 1 : rest[end] == '}' ? -1 : 0;
            if (open == 0)
                break;
        }
        const std::string_view body = rest.substr(stop + 1, end - stop - 1);
        if (prelude.starts_with('@'))
            add_at_rule(prelude, body, depth, losses);
        else
            add_rule(prelude, body, losses);
        rest = end < rest.size() ? trimmed(rest.substr(end + 1)) : std::string_view{};
    }
}

void StyleSheet::add_rule(std::string_view selectors, std::string_view body, art::Losses& losses)
{
    const auto shared = std::make_shared<const std::vector<Declaration>>(declarations(body));
    for (const std::string_view text : split(selectors, ',')) {
        const auto read = selector(text);
        const std::string name{trimmed(text)};
        if (!read && name.find(":hover") == name.npos && name.find(":focus") == name.npos &&
            name.find(":active") == name.npos)
            losses.add(
                {"selector \"" + shortened(name) + "\" of a style sheet", {}, {}, "the rule is ignored"});
        if (read)
            rules_.push_back({*read, shared});
        if (rules_.size() > max_rules)
            throw Failure("more than 10000 rules in style sheets: take out those that are not needed");
    }
}

void StyleSheet::add_at_rule(std::string_view prelude, std::string_view body, int depth, art::Losses& losses)
{
    const std::string name{prelude.substr(0, prelude.find_first_of(" \t\r\n("))};
    if (name == "@charset" || name == "@namespace" || name == "@font-face")
        return; // nothing that is drawn depends on it
    const std::string_view condition = trimmed(prelude.substr(name.size()));
    constexpr int deepest = 8;
    if (name == "@media" && (condition == "screen" || condition == "all") && depth < deepest)
        return add(body, depth + 1, losses);
    losses.add({shortened(name) + " in a style sheet", {}, {}, "what stands in it is ignored"});
}

std::vector<const Rule*> StyleSheet::matching(pugi::xml_node element)
{
    std::vector<const Rule*> result;
    if (rules_.empty())
        return result;
    const std::vector<StyledElement> path = path_of(element, cost_);
    for (const Rule& rule : rules_) {
        if (rule.selector.matches(path, cost_))
            result.push_back(&rule);
        if (cost_ > max_cost)
            throw Failure(
                "too many rules in style sheets for so many elements: take out those that are not needed");
    }
    return result;
}

}
