#include "host/lottie/values/ways.hpp"

#include "host/lottie/values/json.hpp"

#include <cmath>

namespace kfast::lottie {
namespace {

bool has_keys(const Json& values)
{
    return values.is_array() && !values.empty() && values.front().is_object() && values.front().contains("t");
}

std::vector<FileKey> read_keys(const Json& list)
{
    std::vector<FileKey> keys;
    for (const Json& key : list) {
        if (!key.is_object())
            throw WrongMember(key, "is no key: one is an object with \"t\" and \"s\"");
        keys.push_back({number_at(key, "t"), &key, find_member(key, "s"), find_member(key, "e"),
                        truth_at(key, "h", false)});
    }
    std::ranges::stable_sort(keys, {}, &FileKey::time);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (!keys[i].begin && i > 0)
            keys[i].begin = keys[i - 1].end ? keys[i - 1].end : keys[i - 1].begin;
        if (!keys[i].begin)
            throw WrongMember(*keys[i].key, "\"s\" is missing: the first key needs a value");
    }
    return keys;
}

/// The x or the y of a handle, which is a number or one for each component. Null if there is none.
const Json* find_handle(const Json* owner, const char* name, std::size_t index)
{
    const Json* const value = owner ? find_member(*owner, name) : nullptr;
    if (!value || !value->is_array())
        return value;
    if (value->empty())
        return nullptr;
    return &(*value)[index < value->size() ? index : 0];
}

double handle(const Json* owner, const char* name, std::size_t index, double default_value)
{
    const Json* const value = find_handle(owner, name, index);
    return value ? number_of(*value) : default_value;
}

bool is_beyond_all(const Json* handle)
{
    return handle && handle->is_number() && !(std::abs(handle->get<double>()) <= largest_number);
}

}

Property read_property(const Json& owner, const char* name)
{
    const Json* const property = find_member(owner, name);
    if (!property)
        return {};
    const Json* const values =
        property->is_object() && property->contains("k") ? find_member(*property, "k") : property;
    if (!values || (values->is_array() && values->empty()))
        return {};
    if (has_keys(*values))
        return {nullptr, read_keys(*values), read_loop(*property)};
    if (values == property && property->is_object() && !property->contains("v"))
        throw WrongMember(*property, "\"k\" is missing: a property needs a value");
    return {values, {}, {}};
}

double component(const Json& value, std::size_t index, double default_value)
{
    if (!value.is_array())
        return number_of(value);
    return index < value.size() ? number_of(value[index]) : default_value;
}

art::Ease read_ease(const FileKey& key, std::size_t index, bool changes)
{
    if (key.hold)
        return {.kind = art::EaseKind::hold};
    const Json* const out = find_member(*key.key, "o");
    const Json* const in = find_member(*key.key, "i");
    if (!changes &&
        (is_beyond_all(find_handle(out, "y", index)) || is_beyond_all(find_handle(in, "y", index))))
        return {};
    const art::Ease ease{.kind = art::EaseKind::cubic,
                         .x1 = std::clamp(handle(out, "x", index, 0), 0.0, 1.0),
                         .y1 = handle(out, "y", index, 0),
                         .x2 = std::clamp(handle(in, "x", index, 1), 0.0, 1.0),
                         .y2 = handle(in, "y", index, 1)};
    if (ease.x1 == ease.y1 && ease.x2 == ease.y2)
        return {};
    return ease;
}

}
