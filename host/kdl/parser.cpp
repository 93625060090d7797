#include "host/kdl/parser.hpp"

#include "host/kdl/scalar.hpp"
#include "host/kdl/scanner.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace kfast::kdl {

namespace {

constexpr int deepest_node = 256;

void drop_replaced(std::vector<Property>& properties)
{
    if (properties.size() < 2)
        return;
    std::map<std::string, std::size_t> seen;
    std::vector<Property> kept;
    for (auto property = properties.rbegin(); property != properties.rend(); ++property) {
        const auto [later, fresh] = seen.try_emplace(property->name, kept.size());
        if (fresh)
            kept.push_back(std::move(*property));
        else
            kept[later->second].replaces = property->name_span;
    }
    std::ranges::reverse(kept);
    properties = std::move(kept);
}

/// The indent at `offset` if that is the first thing in its line.
std::optional<std::size_t> indent_of(std::string_view text, std::size_t offset)
{
    const std::size_t begin = text.substr(0, offset).find_last_not_of(" \t") + 1; // npos + 1 is 0
    const bool begins_line = begin == 0 || text[begin - 1] == '\n' || text[begin - 1] == '\r';
    return begins_line ? std::optional{offset - begin} : std::nullopt;
}

/// The first of `children` that is indented no deeper than the line of the brace is hardly meant as a child.
std::string hint_of_unclosed(std::string_view text, SourceSpan brace, const std::vector<Node>& children)
{
    const std::string_view line = line_at(text, brace.offset);
    const std::size_t indent = std::min(line.find_first_not_of(" \t"), line.size());
    for (const Node& child : children)
        if (indent_of(text, child.name_span.offset).value_or(indent + 1) <= indent)
            return "add a closing }, perhaps before line " +
                   std::to_string(line_column(text, child.name_span.offset).line);
    return "add a closing }";
}

/// The grammar of nodes, by recursive descent. Each read_ function goes over what it names, or over as much
/// of it as makes sense, after it has reported an error.
class Parser {
public:
    Parser(std::string_view text, Diagnostics& diagnostics) : scanner_(text, diagnostics) {}

    Document read_document();

private:
    /// What has been read of a node so far, for what may follow depends on it.
    struct Progress {
        bool has_block = false;
        bool has_any_block = false; ///< even one after /-
        std::size_t token_end = 0;  ///< of the last name, entry or block
    };

    void warn_of_other_version();
    void read_nodes(std::vector<Node>& nodes, int depth);
    Node read_node(int depth);
    void read_name(Node& node);
    void read_body(Node& node, int depth);
    bool at_node_end();
    void read_block(Node& node, Progress& progress, bool is_dropped, int depth);
    void read_entry(Node& node, Progress& progress, bool is_dropped);
    void read_property(Node& node, Progress& progress, bool is_dropped, const Value& name);
    std::optional<Value> read_value(Progress& progress);
    std::optional<std::string> read_type();
    bool accept_slashdash();
    void report_missing(const std::string& what, const std::string& hint);

    Scanner scanner_;
};

Document Parser::read_document()
{
    Document document;
    if (!check_encoding(scanner_))
        return document;
    warn_of_other_version();
    read_nodes(document.nodes, 1);
    while (scanner_.at("}")) {
        scanner_.error({.offset = scanner_.offset(), .length = 1}, "this } closes nothing",
                       "remove it, or add the { that it belongs to");
        scanner_.accept("}");
        read_nodes(document.nodes, 1);
    }
    return document;
}

void Parser::warn_of_other_version()
{
    Scanner ahead = scanner_;
    const std::size_t begin = ahead.offset();
    if (!ahead.accept("/-"))
        return;
    skip_spaces(ahead);
    if (!ahead.accept("kdl-version") || !ahead.at_space())
        return;
    skip_spaces(ahead);
    if (!ahead.at("2"))
        scanner_.warning(ahead.place_since(begin),
                         "this text says that it is not KDL 2, but is read as KDL 2.0",
                         "check it and write /- kdl-version 2");
}

void Parser::read_nodes(std::vector<Node>& nodes, int depth)
{
    for (;;) {
        scanner_.silence(false);
        skip_line_space(scanner_);
        if (scanner_.at_end() || scanner_.at("}"))
            return;
        const bool is_dropped = accept_slashdash();
        Node node = read_node(depth);
        if (!is_dropped && node.name_span.length > 0)
            nodes.push_back(std::move(node));
    }
}

Node Parser::read_node(int depth)
{
    Node node;
    if (depth > deepest_node) {
        scanner_.error({.offset = scanner_.offset(), .length = 1}, "nodes are nested deeper than 256", {});
        scanner_.stop();
    }
    node.type = read_type();
    read_name(node);
    read_body(node, depth);
    drop_replaced(node.properties);
    return node;
}

void Parser::read_name(Node& node)
{
    const std::size_t begin = scanner_.offset();
    if (!at_scalar(scanner_))
        return report_missing("a node name", scanner_.at(";") ? "remove this ;" : "write a name here");
    Value name;
    if (!read_scalar(scanner_, name))
        return;
    if (!name.string())
        return scanner_.error(scanner_.place_since(begin), "a node begins with its name, not with a value",
                              "put a name before it, or in quotes");
    node.name = *name.string();
    node.name_span = scanner_.place_since(begin);
}

void Parser::read_body(Node& node, int depth)
{
    Progress progress{.token_end = scanner_.offset()};
    while (!at_node_end()) {
        const std::size_t begin = scanner_.offset();
        const bool is_dropped = accept_slashdash();
        if (scanner_.at("{")) {
            read_block(node, progress, is_dropped, depth);
            continue;
        }
        if (progress.has_any_block)
            scanner_.error({.offset = begin, .length = 1}, "more follows on the line after a children block",
                           "begin the next node on a new line or after a ;");
        else if (begin == progress.token_end && !is_dropped)
            scanner_.error({.offset = begin, .length = 1}, "a space is missing here",
                           "put a space between values, or quotes around a text with special characters");
        read_entry(node, progress, is_dropped);
    }
    scanner_.accept(";");
}

bool Parser::at_node_end()
{
    skip_node_space(scanner_);
    return scanner_.at_end() || scanner_.at_newline() || scanner_.at(";") || scanner_.at("}") ||
           scanner_.at("//");
}

void Parser::read_block(Node& node, Progress& progress, bool is_dropped, int depth)
{
    const SourceSpan opening{.offset = scanner_.offset(), .length = 1};
    if (progress.has_block && !is_dropped)
        scanner_.error(opening, "this node has a children block already", "put all children in one block");
    progress.has_block |= !is_dropped;
    progress.has_any_block = true;

    scanner_.accept("{");
    const bool was_silent = scanner_.silence(false);
    std::vector<Node> dropped;
    read_nodes(is_dropped ? dropped : node.children, depth + 1);
    if (!scanner_.accept("}")) {
        scanner_.error(opening, "this { is not closed",
                       hint_of_unclosed(scanner_.text(), opening, is_dropped ? dropped : node.children));
        scanner_.stop();
    }
    scanner_.silence(was_silent);
    progress.token_end = scanner_.offset();
}

void Parser::read_entry(Node& node, Progress& progress, bool is_dropped)
{
    std::optional<Value> value = read_value(progress);
    if (!value)
        return;
    skip_node_space(scanner_);
    if (scanner_.at("="))
        read_property(node, progress, is_dropped, *value);
    else if (!is_dropped)
        node.arguments.push_back(std::move(*value));
}

void Parser::read_property(Node& node, Progress& progress, bool is_dropped, const Value& name)
{
    if (!name.string())
        scanner_.error(name.place, "the name of a property must be a text", "put it in quotes");
    if (name.type)
        scanner_.error(name.place, "the name of a property takes no type", "write it as in name=(type)value");
    scanner_.accept("=");
    skip_node_space(scanner_);
    std::optional<Value> value = read_value(progress);
    if (value && name.string() && !is_dropped)
        node.properties.push_back(
            {.name = *name.string(), .name_span = name.place, .value = std::move(*value)});
}

std::optional<Value> Parser::read_value(Progress& progress)
{
    const std::size_t begin = scanner_.offset();
    Value value;
    value.type = read_type();
    const bool has_scalar = at_scalar(scanner_);
    if (!has_scalar)
        report_missing("a value", "write a value here");
    const bool is_valid = has_scalar && read_scalar(scanner_, value);
    value.place = scanner_.place_since(begin);
    progress.token_end = scanner_.offset();
    return is_valid ? std::optional{std::move(value)} : std::nullopt;
}

std::optional<std::string> Parser::read_type()
{
    const std::size_t begin = scanner_.offset();
    if (!scanner_.accept("("))
        return {};
    skip_node_space(scanner_);
    Value type;
    if (scanner_.at(")"))
        scanner_.error(scanner_.place_since(begin), "this ( ) holds no type", "name one, as in (ms)500");
    else if (!at_scalar(scanner_))
        report_missing("the name of a type", "write a name, as in (ms)500");
    else if (read_scalar(scanner_, type) && !type.string())
        scanner_.error(scanner_.place_since(begin), "the name of a type must be a text", "put it in quotes");
    skip_node_space(scanner_);
    if (!scanner_.accept(")"))
        scanner_.error({.offset = begin, .length = 1}, "this ( is not closed",
                       "add a ) after the name of the type");
    skip_node_space(scanner_);
    return type.string() ? std::optional{*type.string()} : std::nullopt;
}

bool Parser::accept_slashdash()
{
    const std::size_t begin = scanner_.offset();
    if (!scanner_.accept("/-"))
        return false;
    const SourceSpan place = scanner_.place_since(begin);
    skip_line_space(scanner_);
    if (scanner_.at("/-"))
        scanner_.error(place, "two /- follow each other", "one /- per thing that is left out is enough");
    else if (scanner_.at_end() || scanner_.at("}") || scanner_.at(";"))
        scanner_.error(place, "nothing follows this /-", "remove it");
    return true;
}

/// Skips a character that can begin nothing, so that reading gets ahead.
void Parser::report_missing(const std::string& what, const std::string& hint)
{
    const std::size_t begin = scanner_.offset();
    if (scanner_.at("{") || scanner_.at("/-") || at_node_end())
        return scanner_.error({.offset = begin, .length = 1}, what + " is missing here", hint);
    const bool is_equals = scanner_.at("=");
    scanner_.advance();
    scanner_.error(scanner_.place_since(begin), in_quotes(scanner_.since(begin)) + " cannot stand here",
                   is_equals ? "a value is written as name=value or alone"
                             : "put a text with such characters in quotes");
}

}

Document parse(std::string_view text, Diagnostics& diagnostics)
{
    return Parser{text, diagnostics}.read_document();
}

}
