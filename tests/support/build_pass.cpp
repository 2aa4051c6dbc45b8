#include "support/build_pass.h"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "core/context.h"
#include "gpu/commands.h"
#include "run/context_of.h"
#include "support/device.h"
#include "support/scenes.h"
#include "tree/open_nodes.h"

namespace cleave::test {

namespace {

// With workgroups as the device likes them, or as large as they get on any.
const Context& buildContext(bool large) {
    static std::unique_ptr<Context> contexts[2];
    std::unique_ptr<Context>& context = contexts[large ? 1 : 0];
    if (!context) {
        if (!contexts[large ? 0 : 1])
            beforeClose([] {
                for (std::unique_ptr<Context>& c : contexts) c.reset();
            });
        context = contextOf(device(), {}, {true, true, true}, large ? kLargestGroup : 0);
    }
    return *context;
}

// Compares by bytes, and shows both sides by words.
template <class T>
std::string differenceOf(const char* name, std::span<const T> twin, const Buffer& buffer, uint64_t offset,
                         size_t itemBytes = sizeof(T)) {
    std::vector<T> device(twin.size());
    buffer.read(offset, device.data(), twin.size_bytes());
    for (size_t i = 0; i < twin.size(); i++) {
        if (std::memcmp(&twin[i], &device[i], itemBytes) == 0) continue;
        std::ostringstream text;
        text << name << "[" << i << "] differs; words of twin and device:" << std::hex;
        for (size_t w = 0; w < itemBytes / 4; w++) {
            uint32_t a, b;
            std::memcpy(&a, reinterpret_cast<const char*>(&twin[i]) + 4 * w, 4);
            std::memcpy(&b, reinterpret_cast<const char*>(&device[i]) + 4 * w, 4);
            text << " " << a << (a == b ? "=" : "!=") << b;
        }
        return text.str();
    }
    return "";
}

bool isChecked(uint32_t depth, uint32_t maxDepth, uint32_t triangleCount) {
    if (triangleCount < 1000) return true;
    return depth < 2 || depth == maxDepth / 3 || depth == maxDepth / 2 || depth >= maxDepth - 1;
}

// Mixed triangles with some among them that stay out of a tree: not finite, or without area.
std::vector<Triangle> worldOf(uint32_t count, uint32_t seed) {
    std::vector<Triangle> world = mixedTriangles(count, seed);
    for (uint32_t i = 0; i < count; i++) {
        Triangle& t = world[i];
        if (i % 97 == 3) t.b.y = NAN;
        if (i % 97 == 5) t.c = t.a;
        if (i % 97 == 7) t.a.z = INFINITY;
        if (i % 97 == 9) t.c = t.a + (t.b - t.a) * 0.5f;  // on a line, or nearly so
        if (seed % 2 == 0)
            for (vec3* v : {&t.a, &t.b, &t.c}) *v = *v * 1000.0f;  // the scale is not 0
    }
    return world;
}

// Of a build that has the pass.
BuildInfo infoOf(const std::string& pass, uint32_t seed) {
    BuildInfo info;
    for (const twin::Pass& p : twin::levelPasses())
        if (pass == p.row.kernel) info.exact = p.row.builds == Builds::exact;
    info.clip = seed % 4 != 3;
    info.subsample = seed % 3 != 0;
    info.snap = seed % 4 != 2;
    info.costLeaf = seed % 5 == 1 ? 6.5f : 0.0f;
    if (seed % 5 == 2) info.costTraverse = 0.0f;
    if (seed % 7 == 3) info.emptyBonus = 1.0f;
    info.bins = seed % 3 == 2 ? 13 : kBins;
    info.everything = seed % 7 == 4;
    info.exactUpTo = seed % 5 == 4 ? 7 : seed % 2 == 1 ? 32 : kExactUpTo;
    return info;
}

}  // namespace

BuildPair::BuildPair(const std::vector<Triangle>& world, const std::vector<uint32_t>& list, BuildInfo info)
    : arrays(makeArrays(world, list, info)),
      info_(info),
      world_(uploaded(device(), std::span<const Triangle>(world))),
      list_(uploaded(device(), std::span<const uint32_t>(list))) {
    geometry_.vertices = world_.address();
    geometry_.triangleCount = static_cast<uint32_t>(world.size());
    geometry_.vertexCount = 3 * geometry_.triangleCount;
    info_.geometries = &geometry_;
    info_.geometryCount = 1;
    if (!list.empty()) {
        info_.list = list_.address();
        info_.listCount = static_cast<uint32_t>(list.size());
    }
    const BuildSizes sizes = buildSizes(info_);
    scratch_.reserve(device(), {sizes.scratch, sizes.scratchCount});
    tree_ = Buffer(device(), sizes.tree);
    at_ = scratchLayout(countsOf(info_), 0);
    args_ = buildArgs(info_, tree_.address(), scratch_.ranges(), kLongestRow);
    arrays.geometries[0] = geometryData(geometry_, 0);
}

void BuildPair::expand(std::vector<OpenNode> open) {
    Expansion expansion =
        planExpansion(info_, arrays.header.leafRefCount, open.data(), static_cast<uint32_t>(open.size()));
    open_ = uploaded(device(), std::span<const OpenNode>(open));
    expansion.nodes = open_.address();
    args_ = buildArgs(info_, tree_.address(), scratch_.ranges(), kLongestRow, expansion);
    beginExpansion(arrays, info_, open);
}

void BuildPair::upload() {
    const auto put = [&](uint64_t address, const auto& items) {
        const Buffer& scratch = scratch_.buffer(0);
        const bool inTree = address >= tree_.address() && address < tree_.address() + tree_.size();
        const Buffer& buffer = inTree ? tree_ : scratch;
        const_cast<Buffer&>(buffer).write(address - buffer.address(), items.data(), items.size() * sizeof(items[0]));
    };
#define CLEAVE_UPLOAD(name, Element, Array, count) \
    if (!arrays.name.empty()) put(args_.name, arrays.name);
    CLEAVE_SCRATCH_ARRAYS(CLEAVE_UPLOAD)
    CLEAVE_TREE_ARRAYS(CLEAVE_UPLOAD)
#undef CLEAVE_UPLOAD
    put(args_.state, std::span(&arrays.state, 1));
    put(args_.header, std::span(&arrays.header, 1));
    put(args_.state - at_.state.offset + at_.args.offset, std::span(&args_, 1));
}

std::string BuildPair::difference() const {
    std::string found;
    const auto compare = [&](const char* name, const auto& twin, uint64_t address, size_t bytes) {
        // What a workgroup works with is its own business.
        if (!found.empty() || twin.empty() || std::string_view(name).starts_with("work")) return;
        const bool inTree = address >= tree_.address() && address < tree_.address() + tree_.size();
        const Buffer& buffer = inTree ? tree_ : scratch_.buffer(0);
        found = differenceOf(name, std::span(twin.data(), twin.size()), buffer, address - buffer.address(), bytes);
    };
#define CLEAVE_COMPARE(name, Element, Array, count) compare(#name, arrays.name, args_.name, sizeof(Element));
    CLEAVE_SCRATCH_ARRAYS(CLEAVE_COMPARE)
    CLEAVE_TREE_ARRAYS(CLEAVE_COMPARE)
#undef CLEAVE_COMPARE
    compare("state", std::span(&arrays.state, 1), args_.state, sizeof(BuildState));
    compare("header", std::span(&arrays.header, 1), args_.header, offsetof(TreeData, triangles));  // no addresses
    return found;
}

std::string BuildPair::differenceAfter(const twin::Pass& pass, uint32_t depth, bool largeGroups) {
    upload();
    const Context::State& context = buildContext(largeGroups).state();
    Commands commands(device());
    commands.begin();
    Recorder recorder = context.recorder(commands.handle());
    const BuildPush push{args_.state - at_.state.offset + at_.args.offset, depth, pass.row.scans};
    const BuildArgs& args = arrays.args;
    const Level once = levelOf(args.openCount > 0 ? args.openRefs : args.triangleCount, 1, 0, 0, 0, kLongestRow);
    bool isLevelPass = false;
    for (const twin::Pass& p : twin::levelPasses()) isLevelPass = isLevelPass || p.run == pass.run;
    DispatchSize size{};
    std::memcpy(&size,
                reinterpret_cast<const char*>(isLevelPass ? &arrays.state.level[depth] : &once) + pass.row.groups,
                sizeof(size));
    recorder.dispatch(context.kernelOf(pass.row), push, size);
    commands.run();
    pass.run(arrays, depth);
    return difference();
}

void expectPassEqualsTwin(const std::string& name, uint32_t triangleCount, uint32_t seed) {
    SCOPED_TRACE("triangles " + std::to_string(triangleCount) + ", seed " + std::to_string(seed));
    std::vector<uint32_t> list;
    for (uint32_t i = 0; seed % 3 == 1 && i < triangleCount; i++)
        if (i % 3 != 1) list.push_back(i);
    const BuildInfo info = infoOf(name, seed);
    BuildPair pair(worldOf(triangleCount, seed), list, info);
    uint32_t compared = 0;
    const auto run = [&](const twin::Pass& pass, uint32_t depth, bool checked) {
        if (name != pass.row.kernel || !checked) return pass.run(pair.arrays, depth);
        compared++;
        EXPECT_EQ(pair.differenceAfter(pass, depth, (seed + depth) % 2 == 0), "") << name << " at depth " << depth;
    };
    for (const twin::Pass& pass : twin::setupPasses()) run(pass, 0, true);
    const BuildState& state = pair.arrays.state;
    for (uint32_t depth = 0; depth <= state.maxDepth && state.level[depth].nodeCount > 0; depth++)
        for (const twin::Pass& pass : twin::levelPasses()) {
            if (!pass.row.runs(pair.choice())) continue;
            run(pass, depth, isChecked(depth, state.maxDepth, triangleCount));
            if (testing::Test::HasFailure()) return;
        }
    for (const twin::Pass& pass : twin::lastPasses()) run(pass, 0, true);
    EXPECT_TRUE(compared > 0 || triangleCount != kGroup * kGroup + 1) << name << " did not run";
}

uint32_t expectExpansionEqualsTwin(uint32_t triangleCount, uint32_t seed) {
    SCOPED_TRACE("triangles " + std::to_string(triangleCount) + ", seed " + std::to_string(seed));
    BuildInfo info = infoOf("expand", seed);
    info.openUpTo = seed % 2 == 0 ? 100 : 700;
    BuildPair pair(worldOf(triangleCount, seed), {}, info);
    BuildArrays& arrays = pair.arrays;
    for (const twin::Pass& pass : twin::setupPasses()) pass.run(arrays, 0);
    twin::runLevels(arrays, pair.choice());
    const uint32_t included = arrays.state.scene.included;
    std::vector<OpenNode> open =
        openNodesOf(arrays.header.bounds, {arrays.tree.data(), arrays.header.nodeCount}, included, info);
    for (size_t i = open.size(); i-- > 0;)
        if (i % 2 == 1) open.erase(open.begin() + i);
    if (open.empty()) return 0;
    pair.expand(open);
    const auto run = [&](const twin::Pass& pass, uint32_t depth, bool checked) {
        if (!checked) return pass.run(arrays, depth);
        EXPECT_EQ(pair.differenceAfter(pass, depth, (seed + depth) % 2 == 0), "")
            << pass.row.kernel << " at depth " << depth;
    };
    for (const twin::Pass& pass : twin::expandPasses()) run(pass, 0, true);
    for (uint32_t depth = 0; depth <= arrays.state.maxDepth && arrays.state.level[depth].nodeCount > 0; depth++)
        for (const twin::Pass& pass : twin::levelPasses()) {
            if (!pass.row.runs(pair.choice(true))) continue;
            run(pass, depth, depth < 2);
            if (testing::Test::HasFailure()) return 0;
        }
    for (const twin::Pass& pass : twin::lastPasses()) run(pass, 0, true);
    return static_cast<uint32_t>(open.size());
}

}  // namespace cleave::test
