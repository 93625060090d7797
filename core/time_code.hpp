#pragma once

#include "core/byte_reader.hpp"
#include "core/time.hpp"

namespace kfast {

/// Reads a time code of the scene format: twice the frames, or twice the ticks and one. A time beyond the
/// format's limit stays just beyond it, so that sums do not overflow before they are refused.
Time read_time_code(ByteReader& bytes);

}
