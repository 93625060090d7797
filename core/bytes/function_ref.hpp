#pragma once

namespace kfast {

template <class Signature>
class FunctionRef;

/// Any callable with this signature, for the time of the call that it is passed to: it is not copied.
/// Replaces a template parameter where a second copy of the code would cost more than a jump.
template <class Return, class... Arguments>
class FunctionRef<Return(Arguments...)> {
public:
    template <class Function>
    FunctionRef(const Function& function)
        : function_{&function}, call_{[](const void* called, Arguments... arguments) -> Return {
              return (*static_cast<const Function*>(called))(arguments...);
          }}
    {
    }

    Return operator()(Arguments... arguments) const { return call_(function_, arguments...); }

private:
    const void* function_;
    Return (*call_)(const void*, Arguments...);
};

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

/// A member function as one that is given its object: a pointer to it is a single word, and the call of it a
/// jump, which is not so of pointers to members.
template <auto member>
inline constexpr auto* plain_function = &detail::PlainFunction<decltype(member)>::template call<member>;

}
