#include "plot/axis.h"

#include <gtest/gtest.h>

namespace cleave::test {
namespace {

std::vector<std::string> labelsOf(const Axis& axis) {
    std::vector<std::string> labels;
    for (const Tick& tick : axis.ticks()) labels.push_back(tick.label);
    return labels;
}
using Labels = std::vector<std::string>;

TEST(Axis, LinearPutsAMarginAtBothEnds) {
    const Axis axis(Scale::linear, 0.0, 10.0);
    EXPECT_NEAR(axis.at(0.0), 0.5 / 11.0, 1e-12);
    EXPECT_NEAR(axis.at(5.0), 0.5, 1e-12);
    EXPECT_NEAR(axis.at(10.0), 10.5 / 11.0, 1e-12);
    EXPECT_EQ(axis.at(-100.0), 0.0);
    EXPECT_EQ(axis.at(100.0), 1.0);
    EXPECT_EQ(labelsOf(axis), (Labels{"0", "2", "4", "6", "8", "10"}));
}

TEST(Axis, LogarithmicGivesEveryDecadeAsMuch) {
    const Axis axis(Scale::log, 1.0, 100.0);
    EXPECT_NEAR(axis.at(10.0), 0.5, 1e-12);
    EXPECT_NEAR(axis.at(100.0) - axis.at(10.0), axis.at(10.0) - axis.at(1.0), 1e-12);
    EXPECT_EQ(labelsOf(axis), (Labels{"1", "2", "5", "10", "20", "50", "100"}));
    EXPECT_EQ(labelsOf(Axis(Scale::log, 1.0, 10000.0)), (Labels{"1", "10", "100", "1,000", "10,000"}));
    EXPECT_EQ(labelsOf(Axis(Scale::log, 0.2, 1.0)), (Labels{"0.2", "0.5", "1"}));
    EXPECT_EQ(labelsOf(Axis(Scale::log, 600.0, 900.0)), (Labels{"600", "700", "800", "900", "1,000"}));
}

TEST(Axis, SignedLogarithmHasBothSigns) {
    const Axis axis(Scale::signedLog, -9.0, 99.0);
    EXPECT_NEAR(axis.at(0.0), (0.15 + 1.0) / 3.3, 1e-12) << "a decade below zero, two above, 5 % at both ends";
    EXPECT_NEAR(axis.at(99.0), 3.15 / 3.3, 1e-12);
    EXPECT_EQ(labelsOf(axis), (Labels{"\u221210", "\u22121", "0", "1", "10", "100"}));
}

TEST(Axis, OneValueStandsInTheMiddle) {
    for (const Scale scale : {Scale::linear, Scale::log, Scale::signedLog}) {
        EXPECT_NEAR(Axis(scale, 7.0, 7.0).at(7.0), 0.5, 1e-9);
        EXPECT_LT(Axis(scale, 7.0, 7.0).ticks().size(), 12u);
        EXPECT_GE(Axis(scale, 7.0, 7.0).ticks().size(), 1u);
    }
    EXPECT_NEAR(Axis(Scale::linear, 0.0, 0.0).at(0.0), 0.5, 1e-12);
}

}  // namespace
}  // namespace cleave::test
