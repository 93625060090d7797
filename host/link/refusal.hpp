#pragma once

#include "firmware/link/message.hpp"
#include "host/program/failure.hpp"

namespace kfast {

/// A device has said that it will not do what it was asked for.
class Refusal : public Failure {
public:
    explicit Refusal(const link::Failure& failure);

    Status status() const { return status_; }
    /// What belongs to the status.
    std::uint32_t number() const { return number_; }

private:
    Status status_;
    std::uint32_t number_;
};

}
