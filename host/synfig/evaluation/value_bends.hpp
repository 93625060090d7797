#pragma once

#include "host/synfig/evaluation/value_reader.hpp"

#include <set>

namespace kfast::synfig {

/// Adds the times, in seconds, at which a value starts to change differently, or may jump: its waypoints, and
/// when entries of lists come and go. For values that repeat, those from `from` to `to`.
class ValueBends {
public:
    ValueBends(ValueReader& reader, double from, double to) : reader_{reader}, from_{from}, to_{to} {}

    /// Throws Failure if values are nested too deeply.
    void add(const ValueNode& node);
    const std::set<double>& times() const { return times_; }

private:
    void add_new(const ValueNode& node);
    void add_links(const ValueNode& node);
    void add_repeats(const ValueNode& node);

    ValueReader& reader_;
    double from_;
    double to_;
    std::set<double> times_;
    std::set<const ValueNode*> seen_;
    int depth_ = 0;
};

}
