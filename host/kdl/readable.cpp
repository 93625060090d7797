#include "host/kdl/readable.hpp"

#include "host/kdl/canonical.hpp"
#include "host/kdl/escape.hpp"

#include <algorithm>

namespace kfast::kdl {
namespace {

constexpr std::size_t indent_width = 4;
constexpr std::size_t widest_line = 110;

std::string indentation(std::size_t depth) { return std::string(depth * indent_width, ' '); }

bool has_lines(const std::string& text) { return text.find('\n') != std::string::npos; }

/// Whether nothing in it but the ends of its lines needs an escape.
bool is_plain(std::string text)
{
    std::ranges::replace(text, '\n', ' ');
    return escaped(text, Unseen::as_codes) == text;
}

std::string lines_form(const std::string& text, std::size_t depth)
{
    std::string form = "\"\"\"\n";
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        form += indentation(depth + 1) + text.substr(at, end - at) + '\n';
        at = end + 1;
    }
    return form + indentation(depth + 1) + "\"\"\"";
}

struct DataForm {
    std::size_t depth = 0;

    std::string operator()(Null) const { return "#null"; }
    std::string operator()(bool value) const { return value ? "#true" : "#false"; }
    std::string operator()(const Number& number) const { return number.canonical; }
    std::string operator()(const std::string& text) const
    {
        return has_lines(text) && is_plain(text) ? lines_form(text, depth) : string_form(text);
    }
};

std::string form_of(const Value& value, std::size_t depth)
{
    const std::string type = value.type ? '(' + string_form(*value.type) + ')' : std::string{};
    return type + std::visit(DataForm{depth}, value.data);
}

/// All but the children.
std::string head_of(const Node& node, std::size_t depth)
{
    std::string head =
        (node.type ? '(' + string_form(*node.type) + ')' : std::string{}) + string_form(node.name);
    for (const Value& argument : node.arguments)
        head += ' ' + form_of(argument, depth);
    for (const Property& property : node.properties)
        head += ' ' + string_form(property.name) + '=' + form_of(property.value, depth);
    return head;
}

bool is_leaf(const Node& node) { return node.children.empty(); }

/// Different nodes with properties are easier to read below each other.
bool is_mixed(const Node& node)
{
    const auto is_other = [&](const Node& child) { return child.name != node.children.front().name; };
    const auto has_properties = [](const Node& child) { return !child.properties.empty(); };
    return std::ranges::any_of(node.children, is_other) && std::ranges::any_of(node.children, has_properties);
}

/// Nothing if that does not fit.
std::string one_line(const Node& node, const std::string& head, std::size_t depth)
{
    if (is_mixed(node))
        return {};
    std::string line = head + " {";
    for (const Node& child : node.children) {
        if (!is_leaf(child) || line.size() > widest_line)
            return {};
        line += (line.back() == '{' ? " " : "; ") + head_of(child, depth);
    }
    line += " }";
    return has_lines(line) || line.size() + depth * indent_width > widest_line ? std::string{} : line;
}

class Page {
public:
    explicit Page(std::span<const std::string_view> crowded) : crowded_{crowded} {}

    void add(std::span<const Node> nodes, std::size_t depth)
    {
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (i > 0 && shares_line(nodes[i - 1], nodes[i]))
                add_to_line(head_of(nodes[i], depth), depth);
            else
                add(nodes[i], depth);
        end_line();
    }

    std::string take() { return std::move(text_); }

private:
    bool shares_line(const Node& before, const Node& node) const
    {
        return before.name == node.name && is_leaf(before) && is_leaf(node) &&
               std::ranges::find(crowded_, node.name) != crowded_.end();
    }

    void add(const Node& node, std::size_t depth)
    {
        end_line();
        const std::string head = head_of(node, depth);
        line_ = indentation(depth) + head;
        if (is_leaf(node))
            return;
        if (const std::string whole = one_line(node, head, depth); !whole.empty()) {
            line_ = indentation(depth) + whole;
            return;
        }
        line_ += " {";
        end_line();
        add(std::span{node.children}, depth + 1);
        line_ = indentation(depth) + '}';
    }

    void add_to_line(const std::string& head, std::size_t depth)
    {
        const bool fits =
            line_.size() + 2 + head.size() <= widest_line && !has_lines(line_) && !has_lines(head);
        if (fits) {
            line_ += "; " + head;
            return;
        }
        end_line();
        line_ = indentation(depth) + head;
    }

    void end_line()
    {
        if (!line_.empty())
            text_ += line_ + '\n';
        line_.clear();
    }

    std::span<const std::string_view> crowded_;
    std::string text_ = {};
    std::string line_ = {}; ///< that is not at its end yet
};

}

std::string readable(std::span<const Node> nodes, std::span<const std::string_view> crowded)
{
    Page page{crowded};
    page.add(nodes, 0);
    return page.take();
}

}
