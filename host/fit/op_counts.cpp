#include "host/fit/op_counts.hpp"

namespace kfast::fit {

OpLog::OpLog()
{
    clear();
    op_counter = this;
}

OpLog::~OpLog() { op_counter = nullptr; }

void OpLog::clear()
{
    counts_by_item_.clear();
    counts = counts_for(0);
}

}
