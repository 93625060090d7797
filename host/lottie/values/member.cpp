#include "host/lottie/values/member.hpp"

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

}
