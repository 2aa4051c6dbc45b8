#include <gtest/gtest.h>

#include "support/build_pass.h"
#include "support/scenes.h"

namespace cleave::test {

// Of `expand` and of the passes after it, which begin at several nodes then.
TEST(Expand, EqualsTwinAtEverySize) {
    uint32_t seed = 1;
    uint32_t expanded = 0;
    for (const uint32_t n : kSizes) expanded += expectExpansionEqualsTwin(n, seed++);
    EXPECT_GT(expanded, 500u);
}

}  // namespace cleave::test
