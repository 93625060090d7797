#pragma once

namespace kfast::test {

/// How many rounds of a test that takes long are run: `all`, or, where sanitizers slow it, the first
/// twenty-fourth of them, and one at least.
constexpr int rounds(int all) { return all < KFAST_SHARE_OF_ROUNDS ? 1 : all / KFAST_SHARE_OF_ROUNDS; }

}
