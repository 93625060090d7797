#pragma once

namespace kfast {

template <class Signature>
class FunctionRef;

/// Whatever can be called so, for the time of a call that it is handed to: it is not copied. In place of a
/// template parameter where a second copy of the code would cost more than a jump.
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

}
