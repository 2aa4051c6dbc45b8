#include <gtest/gtest.h>

#include "support/build_pass.h"
#include "support/scenes.h"

namespace cleave::test {

TEST(OpenBins, EqualsTwinAtEverySize) {
    uint32_t seed = 1;
    for (uint32_t n : kSizes) expectPassEqualsTwin("open_bins", n, seed++);
}

}  // namespace cleave::test
