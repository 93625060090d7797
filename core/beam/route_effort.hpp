#pragma once

#include <cstdint>

namespace kfast {

/// What may still be done for a route.
class RouteEffort {
public:
    explicit RouteEffort(std::uint32_t travels) : left_{travels} {}

    bool is_spent() const { return left_ == 0; }
    void spend(std::uint32_t travels) { left_ = travels < left_ ? left_ - travels : 0; }
    std::uint32_t left() const { return left_; }

private:
    std::uint32_t left_;
};

}
