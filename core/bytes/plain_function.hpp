#pragma once

namespace kfast {
namespace detail {

template <class Member>
struct PlainFunction;

template <class Class, class Return, class... Arguments>
struct PlainFunction<Return (Class::*)(Arguments...)> {
    template <auto member>
    static Return call(Class& object, Arguments... arguments)
    {
        return (object.*member)(arguments...);
    }
};

template <class Class, class Return, class... Arguments>
struct PlainFunction<Return (Class::*)(Arguments...) const> {
    template <auto member>
    static Return call(const Class& object, Arguments... arguments)
    {
        return (object.*member)(arguments...);
    }
};

}

/// A member function as one that is told its object: a pointer to it is a single word, and the call of it a
/// jump, which is not so of pointers to members.
template <auto member>
inline constexpr auto* plain_function = &detail::PlainFunction<decltype(member)>::template call<member>;

}
