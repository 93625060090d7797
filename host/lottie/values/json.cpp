#include "host/lottie/values/json.hpp"

#include "host/art/budget.hpp"
#include "host/program/failure.hpp"

#include <cctype>
#include <cmath>

namespace kfast::lottie {

namespace {

std::string kind(const Json& value)
{
    if (value.is_string())
        return "a text";
    if (value.is_object())
        return "an object";
    if (value.is_array())
        return "a list";
    if (value.is_boolean())
        return "true or false";
    return value.is_null() ? "null" : "a number";
}

const Json& needed(const Json& owner, const char* name)
{
    const Json* const member = find_member(owner, name);
    if (!member)
        throw WrongMember(owner, std::string{"\""} + name + "\" is missing: export the file again");
    return *member;
}

}

const Json* find_member(const Json& owner, const char* name)
{
    if (!owner.is_object())
        return nullptr;
    const auto member = owner.find(name);
    return member == owner.end() || member->is_null() ? nullptr : &*member;
}

double number_of(const Json& value)
{
    if (value.is_string())
        throw WrongMember(value, "is a text instead of a number: take the quotes away");
    if (!value.is_number())
        throw WrongMember(value, "is " + kind(value) + " instead of a number");
    const double number = value.get<double>();
    if (!(std::abs(number) <= largest_number))
        throw WrongMember(value, "is too large: at most 1000000000");
    return number;
}

double number_at(const Json& owner, const char* name, double default_value)
{
    const Json* const member = find_member(owner, name);
    return member ? number_of(*member) : default_value;
}

double number_at(const Json& owner, const char* name) { return number_of(needed(owner, name)); }

bool truth_at(const Json& owner, const char* name, bool default_value)
{
    const Json* const member = find_member(owner, name);
    if (!member)
        return default_value;
    return member->is_boolean() ? member->get<bool>() : number_of(*member) != 0;
}

std::string text_at(const Json& owner, const char* name)
{
    const Json* const member = find_member(owner, name);
    if (!member)
        return {};
    if (!member->is_string())
        throw WrongMember(*member, "is " + kind(*member) + " instead of a text");
    return member->get<std::string>();
}

std::string name_at(const Json& owner, const char* name)
{
    const Json* const member = find_member(owner, name);
    return member && member->is_string() ? member->get<std::string>() : std::string{};
}

std::string identifier_at(const Json& owner, const char* name)
{
    const Json* const member = find_member(owner, name);
    return member && member->is_number() ? member->dump() : text_at(owner, name);
}

const Json& array_at(const Json& owner, const char* name)
{
    const Json& member = needed(owner, name);
    if (!member.is_array())
        throw WrongMember(member, "is " + kind(member) + " instead of a list");
    return member;
}

int whole_at(const Json& owner, const char* name, int default_value)
{
    return static_cast<int>(number_at(owner, name, default_value));
}

namespace {

[[noreturn]] void fail(const SourceText& source, std::size_t byte, const std::string& text)
{
    const LineColumn place = line_column(source.text, byte > 0 ? byte - 1 : 0);
    throw Failure(source.name + ':' + std::to_string(place.line) + ':' + std::to_string(place.column) + ": " +
                  text);
}

/// Done before parsing, for the parser keeps what it has read on a stack of its own, and each value takes
/// more memory than its text.
void check_extent(const SourceText& source)
{
    int depth = 0;
    std::size_t values = 1; // at least as many as there are: each list, and what follows a comma
    bool in_text = false;
    for (std::size_t i = 0; i < source.text.size(); ++i) {
        const char sign = source.text[i];
        if (in_text) {
            i += sign == '\\' ? 1 : 0;
            in_text = sign != '"';
        } else if (sign == '"') {
            in_text = true;
        } else if (sign == '[' || sign == '{') {
            ++values;
            if (++depth > deepest_json)
                fail(source, i + 1,
                     "lists and objects lie more than " + std::to_string(deepest_json) +
                         " deep in each other: flatten groups or precompositions");
        } else if (sign == ']' || sign == '}') {
            --depth;
        } else if (sign == ',') {
            ++values;
        }
    }
    art::Budget::check_parsed(source.name, values, "values of JSON");
}

/// "…: syntax error while parsing value - unexpected …": what follows the dash.
std::string reason(const Json::parse_error& error)
{
    const std::string text = error.what();
    const std::size_t dash = text.find(" - ");
    return dash == std::string::npos ? text : text.substr(dash + 3);
}

bool is_plain(const std::string& name)
{
    return !name.empty() &&
           std::ranges::all_of(name, [](unsigned char sign) { return std::isalnum(sign) || sign == '_'; });
}

void add_step(std::string& path, const std::string& name)
{
    if (!is_plain(name)) {
        path += '[' + Json(name).dump() + ']';
        return;
    }
    if (!path.empty())
        path += '.';
    path += name;
}

/// Extends the path by the members from `from` to the place.
bool find_path(const Json& from, const Json* place, std::string& path)
{
    if (&from == place)
        return true;
    const std::size_t length = path.size();
    if (from.is_object()) {
        for (const auto& [name, member] : from.items()) {
            add_step(path, name);
            if (find_path(member, place, path))
                return true;
            path.resize(length);
        }
    } else if (from.is_array()) {
        for (std::size_t i = 0; i < from.size(); ++i) {
            path += '[' + std::to_string(i) + ']';
            if (find_path(from[i], place, path))
                return true;
            path.resize(length);
        }
    }
    return false;
}

}

Json parse_json(const SourceText& source)
{
    check_extent(source);
    try {
        return Json::parse(source.text);
    } catch (const Json::parse_error& error) {
        fail(source, error.byte, "this is no JSON: " + reason(error) + ". Export the file again");
    } catch (const Json::exception& error) {
        throw Failure(source.name + ": a number is too large for JSON: export the file again");
    }
}

std::string path_to(const Json& root, const Json* place)
{
    std::string path;
    return find_path(root, place, path) ? path : "";
}

}
