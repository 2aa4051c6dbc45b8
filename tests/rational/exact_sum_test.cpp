#include "tree/exact_sum.h"

#include <gtest/gtest.h>

#include "rational/rational.h"

namespace cleave {
namespace {

using test::exactly;
using test::Rational;

void expectSum(const ExactSum& sum, const Rational& truth) {
    ASSERT_EQ(sum.sign(), sgn(truth));
    const Rational error = abs(exactly(sum.value()) - truth), allowed = abs(truth) * exactly(0x1p-51);
    ASSERT_LE(error, allowed);
}

double anyDouble(std::mt19937& random) {
    const double x = std::uniform_real_distribution<double>(-1.0, 1.0)(random);
    return std::ldexp(x, static_cast<int>(random() % 400) - 200);
}

TEST(ExactSum, OfDoublesOfAllSizes) {
    int zeros = 0;
    for (uint seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        ExactSum sum;
        Rational truth;
        std::vector<double> added;
        for (auto n = 1 + random() % 40; n > 0; --n) {
            // Half of what is added takes something back: sums of 0 and of a last bit are what matters.
            const bool takesBack = !added.empty() && random() % 2 == 0;
            const double x = takesBack ? -added[random() % added.size()] : anyDouble(random);
            added.push_back(x);
            sum.add(x);
            truth += exactly(x);
            expectSum(sum, truth);
        }
        for (const double x : added) sum.add(-x);
        expectSum(sum, 0);
        zeros += truth == 0 ? 1 : 0;
    }
    EXPECT_GT(zeros, 10);
}

TEST(ExactSum, OfProductsAndMultiples) {
    for (uint seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        ExactSum sum, other;
        Rational truth, otherTruth;
        for (auto n = 1 + random() % 8; n > 0; --n) {
            const double a = anyDouble(random), b = anyDouble(random);
            sum.addProduct(a, b);
            truth += exactly(a) * exactly(b);
            if (random() % 2 == 0) {  // what the product's rounding left over remains
                sum.add(-(a * b));
                truth -= exactly(a * b);
            }
            other.addProduct(b, b);
            otherTruth += exactly(b) * exactly(b);
        }
        const double factor = std::ldexp(test::anyFloat(random, 1.0f), static_cast<int>(random() % 20));
        sum.addMultiple(other, factor);
        truth += otherTruth * exactly(factor);
        expectSum(sum, truth);
    }
}

TEST(ExactSum, OfDeterminants) {
    int zeros = 0;
    for (uint seed = 0; seed < 3000; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        vec3 v[3];
        for (vec3& x : v) x = test::anyScales(random, 120);
        if (random() % 3 == 0) v[2] = v[0] + v[1];  // flat, but for rounding
        if (random() % 3 == 0)
            for (vec3& x : v) x = test::onGrid(x, 2);
        ExactSum sum;
        addDeterminant(sum, v[0], v[1], v[2], -1.0);
        const Rational truth = -test::determinant(exactly(v[0]), exactly(v[1]), exactly(v[2]));
        expectSum(sum, truth);
        zeros += truth == 0 ? 1 : 0;
    }
    EXPECT_GT(zeros, 100);
}

}  // namespace
}  // namespace cleave
