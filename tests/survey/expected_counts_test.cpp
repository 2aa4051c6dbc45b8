// Survey, section 4: how many inner nodes and leaves a uniformly distributed line through the root box meets, and how
// many triangles these leaves list, are sums of surface areas. Judged by walking such lines, without an early exit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "builders/builder_names.h"
#include "measure/statistics.h"
#include "survey/survey_scenes.h"

namespace cleave {
namespace {

struct Line {
    dvec3 origin, direction;
};

double uniform(test::Random& random) { return static_cast<double>(random.unit()) + 0x1p-25; }  // inside (0, 1)

// Isotropic and uniform: any direction, through any point of the disc across it that the ball around the box covers.
Line lineThroughBall(test::Random& random, dvec3 centre, double radius) {
    constexpr double kTwoPi = 6.283185307179586;
    const double z = 2.0 * uniform(random) - 1.0, angle = kTwoPi * uniform(random), r = std::sqrt(1.0 - z * z);
    const dvec3 direction(r * std::cos(angle), r * std::sin(angle), z);
    const dvec3 other = std::fabs(z) < 0.7 ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
    const dvec3 across = glm::normalize(glm::cross(direction, other)), third = glm::cross(direction, across);
    const double offset = radius * std::sqrt(uniform(random)), turn = kTwoPi * uniform(random);
    return {centre + offset * (std::cos(turn) * across + std::sin(turn) * third), direction};
}

// The part of the line in the box, from.t to to.t; empty if it misses.
struct Part {
    double from, to;
};
Part partIn(const Line& line, const Box& box) {
    Part part{-1e30, 1e30};
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (double{box.lo[axis]} - line.origin[axis]) / line.direction[axis];
        const double b = (double{box.hi[axis]} - line.origin[axis]) / line.direction[axis];
        part.from = std::max(part.from, std::min(a, b));
        part.to = std::min(part.to, std::max(a, b));
    }
    return part;
}

struct Met {
    double inner = 0, leaves = 0, triangles = 0;
};

// A flat root box is met in a point: then the plane's side of that point decides.
void walk(const KdTree& tree, uint32_t index, const Line& line, Part part, Met& met) {
    const KdNode node = tree.nodes[index];
    if (isLeaf(node)) {
        met.leaves += 1;
        met.triangles += leafCount(node);
        return;
    }
    met.inner += 1;
    const int axis = static_cast<int>(nodeAxis(node));
    const double plane = nodePosition(node), at = (plane - line.origin[axis]) / line.direction[axis];
    const bool ascends = line.direction[axis] > 0.0;
    const uint32_t near = nodeChild(node) + (ascends ? 0 : 1), far = nodeChild(node) + (ascends ? 1 : 0);
    if (part.from < at) walk(tree, near, line, {part.from, std::min(part.to, at)}, met);
    if (part.to >= at) walk(tree, far, line, {std::max(part.from, at), part.to}, met);
}

// Mean and the standard error of it.
class Sample {
  public:
    void add(double x) {
        ++count_;
        const double before = x - mean_;
        mean_ += before / count_;
        squares_ += before * (x - mean_);
    }
    double mean() const { return mean_; }
    double error() const { return std::sqrt(squares_ / (count_ - 1) / count_); }

  private:
    double count_ = 0, mean_ = 0, squares_ = 0;
};

struct Means {
    Sample inner, leaves, triangles;
};

Means walkLines(const KdTree& tree, uint32_t lines, uint32_t seed) {
    const dvec3 lo(tree.bounds.lo), hi(tree.bounds.hi);
    test::Random random(seed);
    Means means;
    for (uint32_t met = 0; met < lines;) {
        const Line line = lineThroughBall(random, 0.5 * (lo + hi), 0.5 * glm::length(hi - lo));
        const Part part = partIn(line, tree.bounds);
        if (part.from > part.to) continue;
        ++met;
        Met m;
        walk(tree, 0, line, part, m);
        means.inner.add(m.inner);
        means.leaves.add(m.leaves);
        means.triangles.add(m.triangles);
    }
    return means;
}

struct NamedScene {
    const char* name;
    std::vector<Triangle> triangles;
};

std::vector<NamedScene> scenes() {
    std::vector<Triangle> flat = test::soup(3, 1500, 0.05f), crowded = test::soup(4, 1500, 0.02f),
                          snapped = test::soup(5, 2500, 0.1f), sheet;
    for (Triangle& t : flat)
        for (vec3* v : {&t.a, &t.b, &t.c}) v->y *= 0.01f;
    for (Triangle& t : crowded)
        for (vec3* v : {&t.a, &t.b, &t.c}) *v = *v * *v * *v;
    for (Triangle& t : snapped)
        for (vec3* v : {&t.a, &t.b, &t.c}) *v = glm::round(*v * 16.0f);
    for (uint32_t i = 0; i < 900; ++i) {  // all in one plane: the root box has no height
        const float x = static_cast<float>(i % 30), y = static_cast<float>(i / 30);
        sheet.push_back({{x, y, 2.0f}, {x + 1, y, 2.0f}, {x, y + 1, 2.0f}});
    }
    return {{"soup", test::soup(2, 1500, 0.08f)},  {"flat box", flat},   {"crowded", crowded},
            {"turned grid", test::turnedGrid(25)}, {"one plane", sheet}, {"snapped", snapped}};
}

void expectNear(const char* what, const Sample& walked, double expected) {
    EXPECT_NEAR(walked.mean(), expected, 4.0 * walked.error() + 1e-9 * expected) << what;
}

TEST(ExpectedCounts, AreWhatUniformLinesMeet) {
    constexpr uint32_t kLines = 20000;
    uint32_t seed = 0;
    std::printf(
        "%u lines: difference in standard errors\nscene        builder         seed   inner  leaves  triangles\n",
        kLines);
    for (const NamedScene& scene : scenes()) {
        const TriangleSet set = makeTriangleSet(scene.triangles);
        for (const TreeBuilder& builder : cpuBuilders()) {
            SCOPED_TRACE(testing::Message() << scene.name << ", " << builder.name);
            const KdTree tree = builder.build(set, {}).tree;
            const TreeStatistics s = computeStatistics(tree);
            ASSERT_TRUE(s.expectedInner && s.expectedLeaves && s.expectedTriangles);
            const Means means = walkLines(tree, kLines, ++seed);
            expectNear("inner nodes", means.inner, *s.expectedInner);
            expectNear("leaves", means.leaves, *s.expectedLeaves);
            expectNear("triangles", means.triangles, *s.expectedTriangles);
            const auto off = [](const Sample& walked, double expected) {
                return walked.error() > 0 ? (walked.mean() - expected) / walked.error() : 0.0;
            };
            std::printf("%-11s  %-14s  %4u  %6.2f  %6.2f  %9.2f\n", scene.name, std::string(builder.name).c_str(), seed,
                        off(means.inner, *s.expectedInner), off(means.leaves, *s.expectedLeaves),
                        off(means.triangles, *s.expectedTriangles));
        }
    }
}

// The walk itself, where the answer is known: a box cut in half. The sides of a unit cube have areas 4 of 6 each.
TEST(ExpectedCounts, OfACubeCutInHalf) {
    KdTree tree;
    tree.bounds = {vec3(0), vec3(1)};
    tree.nodes = {innerNode(0, 0.5f, 1), leafNode(0, 1), leafNode(1, 0)};
    tree.leafTriangles = {0};
    const Means means = walkLines(tree, 40000, 12);
    EXPECT_EQ(means.inner.mean(), 1.0);
    EXPECT_NEAR(means.leaves.mean(), 8.0 / 6.0, 4.0 * means.leaves.error());
    EXPECT_NEAR(means.triangles.mean(), 4.0 / 6.0, 4.0 * means.triangles.error());
    EXPECT_LT(means.leaves.error(), 0.003);
}

}  // namespace
}  // namespace cleave
