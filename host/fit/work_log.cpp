#include "host/fit/work_log.hpp"

namespace kfast::fit {

WorkLog::WorkLog()
{
    clear();
    work_tally = this;
}

WorkLog::~WorkLog() { work_tally = nullptr; }

void WorkLog::clear()
{
    counts_by_item_.clear();
    counts = counts_for(0);
}

}
