#include "app/options.h"

#include <gtest/gtest.h>

#include "app/frame_files.h"
#include "app/option_values.h"
#include "base/error.h"
#include "builders/builder_names.h"

namespace cleave::test {
namespace {

Request request(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "cleave");
    return parseCommandLine(static_cast<int>(arguments.size()), arguments.data());
}
Options parse(const std::vector<const char*>& arguments) { return std::get<Options>(request(arguments)); }

// The text of the refusal; empty if the use is right.
std::string refusal(const std::vector<const char*>& arguments) {
    try {
        request(arguments);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}
void expectRefused(const std::vector<const char*>& arguments, const std::string& part) {
    const std::string text = refusal(arguments);
    EXPECT_NE(text.find(part), std::string::npos) << "refusal: '" << text << "', wanted: " << part;
}

TEST(Options, AskForHitsInOneWay) {
    const Options all = parse({"trace", "a.glb", "r.npy", "--all", "8"});
    EXPECT_EQ(all.query, Query::all);
    EXPECT_EQ(all.hitsPerRay, 8u);
    EXPECT_EQ(parse({"trace", "a.glb", "r.npy", "--count"}).query, Query::count);
    EXPECT_EQ(parse({"trace", "a.glb", "r.npy", "--count", "--signed"}).query, Query::signedCount);
    EXPECT_EQ(parse({"trace", "a.glb", "r.npy", "--signed", "--count"}).query, Query::signedCount);
    for (const char* none : {"0", "-1", "many", "99999999"})
        expectRefused({"trace", "a.glb", "r.npy", "--all", none}, "whole number");
    expectRefused({"trace", "a.glb", "r.npy", "--signed"}, "--count");
    expectRefused({"trace", "a.glb", "r.npy", "--all", "3", "--count"}, "--all");
    expectRefused({"trace", "a.glb", "r.npy", "--any", "--count"}, "--any");
    expectRefused({"trace", "a.glb", "r.npy", "--count", "--check", "5"}, "--check");
}

TEST(Options, QueryAsksOneQuestion) {
    const Options nearest = parse({"query", "a.glb", "p.npy", "--nearest", "--within", "0.5"});
    EXPECT_EQ(nearest.command, Command::query);
    EXPECT_EQ(nearest.question, Question::nearest);
    EXPECT_EQ(nearest.within, 0.5f);
    EXPECT_EQ(nearest.rays, "p.npy");
    EXPECT_EQ(nearest.output, "out.npy");
    EXPECT_EQ(parse({"query", "a.glb", "p.npy", "--nearest"}).within, infinity());
    EXPECT_EQ(parse({"query", "a.glb", "p.npy", "--contains"}).question, Question::contains);
    EXPECT_EQ(parse({"query", "a.glb", "p.npy", "--overlaps"}).question, Question::overlaps);
    expectRefused({"query", "a.glb", "p.npy"}, "--nearest");
    expectRefused({"query", "a.glb", "p.npy", "--nearest", "--contains"}, "--contains");
    expectRefused({"query", "a.glb", "p.npy", "--contains", "--within", "1"}, "--nearest");
    for (const char* none : {"-1", "nan", "far"})
        expectRefused({"query", "a.glb", "p.npy", "--nearest", "--within", none}, "number of 0 or more");
}

TEST(Options, Defaults) {
    const Options o = parse({"render"});
    EXPECT_EQ(o.command, Command::render);
    EXPECT_TRUE(o.scenes.empty());
    EXPECT_EQ(o.output, "out.png");
    EXPECT_EQ(o.builders, std::vector{Builder::gpu});
    EXPECT_EQ(o.width, 1280u);
    EXPECT_EQ(o.height, 720u);
    EXPECT_EQ(o.view, View::shaded);
    EXPECT_EQ(o.settings.threads, 2u);
    EXPECT_EQ(o.settings.memory, 0u);
    EXPECT_TRUE(o.settings.clip);
    EXPECT_TRUE(o.settings.subsample);
    EXPECT_FALSE(o.json || o.eye || o.look || o.fov || o.quiet);
    EXPECT_EQ(o.check, 0u);
}

TEST(Options, RenderTakesThemAll) {
    const Options o =
        parse({"render",  "a.glb",         "-o",     "b.png",       "--size",  "64x48",     "--camera", "main",
               "--eye",   "-1,2e0,-.5",    "--look", "0,0,0",       "--fov",   "30",        "--view",   "leaves",
               "--check", "100",           "--json", "c.json",      "--quiet", "--builder", "exact",    "--traversal",
               "restart", "--device",      "llvm",   "--threads",   "3",       "--memory",  "512M",     "--bins",
               "16",      "--exact-up-to", "8",      "--max-depth", "20",      "--clip",    "off",      "--subsample",
               "off"});
    EXPECT_EQ(o.scenes.front(), "a.glb");
    EXPECT_EQ(o.output, "b.png");
    EXPECT_EQ(o.width, 64u);
    EXPECT_EQ(o.height, 48u);
    EXPECT_EQ(o.camera, "main");
    EXPECT_EQ(*o.eye, glm::dvec3(-1, 2, -0.5));
    EXPECT_EQ(*o.look, glm::dvec3(0));
    EXPECT_EQ(*o.fov, 30.0);
    EXPECT_EQ(o.view, View::leaves);
    EXPECT_EQ(o.check, 100u);
    EXPECT_EQ(*o.json, "c.json");
    EXPECT_TRUE(o.quiet);
    EXPECT_EQ(o.builders, std::vector{Builder::exact});
    EXPECT_EQ(o.device, "llvm");
    EXPECT_EQ(o.settings.threads, 3u);
    EXPECT_EQ(o.settings.memory, 512u << 20);
    EXPECT_EQ(o.settings.bins, 16u);
    EXPECT_EQ(o.settings.exactUpTo, 8u);
    EXPECT_EQ(o.settings.maxDepth, 20u);
    EXPECT_FALSE(o.settings.clip);
    EXPECT_FALSE(o.settings.subsample);
}

TEST(Options, OtherCommands) {
    const Options trace = parse({"trace", "a.glb", "r.npy", "--any"});
    EXPECT_EQ(trace.rays, "r.npy");
    EXPECT_EQ(trace.output, "hits.npy");
    EXPECT_EQ(trace.query, Query::any);
    const Options bench =
        parse({"bench", "a.glb", "b.glb", "--runs", "7", "--interior", "--builder", "gpu,exact,twin"});
    EXPECT_EQ(bench.scenes.size(), 2u);
    EXPECT_EQ(bench.runs, 7u);
    EXPECT_TRUE(bench.interior);
    EXPECT_EQ(bench.builders, (std::vector{Builder::gpu, Builder::exact, Builder::twin}));
    EXPECT_TRUE(parse({"bench", "a.glb", "--survey"}).survey);
    EXPECT_TRUE(parse({"info", "a.glb", "--validate"}).validate);
    EXPECT_EQ(parse({"info", "a.glb", "--save-tree", "t"}).saveTree, "t");
    EXPECT_EQ(parse({"trace", "a.glb", "r.npy", "--tree", "t"}).tree, "t");
    EXPECT_EQ(parse({"devices"}).command, Command::devices);
}

TEST(Options, OfStability) {
    const Options plain = parse({"stability"});
    EXPECT_TRUE(plain.builders.empty()) << "all";
    EXPECT_FALSE(plain.quick);
    EXPECT_FALSE(plain.leaks);
    const Options o = parse(
        {"stability", "a.glb", "--quick", "--cases", "fan,stack", "--rays", "50", "--seed", "9", "--builder", "exact"});
    EXPECT_TRUE(o.quick);
    EXPECT_EQ(o.cases, (std::vector<std::string>{"fan", "stack"}));
    EXPECT_EQ(o.rayCount, 50u);
    EXPECT_EQ(o.seed, 9u);
    EXPECT_EQ(o.builders, std::vector{Builder::exact});
    EXPECT_EQ(o.scenes.size(), 1u);
    EXPECT_EQ(*parse({"stability", "--leaks"}).leaks, 100'000'000u);
    EXPECT_EQ(*parse({"stability", "--leaks", "5"}).leaks, 5u);
    expectRefused({"stability", "--cases", "none"}, "offset-1e5, offset-1e6");
    expectRefused({"stability", "--leaks", "few"}, "whole number");
}

TEST(Options, EveryBuilderOfTheCpuHasAName) {
    for (const TreeBuilder& builder : cpuBuilders())
        EXPECT_EQ(nameOf(parse({"info", "a.glb", "--builder", builder.name.data()}).builders.front()), builder.name);
}

TEST(Options, KnobsOfMedians) {
    const Options o = parse({"info", "a.glb", "--axes", "widest", "--leaf-size", "7"});
    EXPECT_EQ(o.settings.axes, AxisChoice::widest);
    EXPECT_EQ(o.settings.leafSize, 7u);
    EXPECT_EQ(parse({"info", "a.glb"}).settings.axes, AxisChoice::cycle);
    expectRefused({"render", "--axes", "none"}, "all, widest, cycle");
    expectRefused({"render", "--leaf-size", "0"}, "from 1 to");
}

TEST(Options, HelpAndVersion) {
    EXPECT_NE(std::get<std::string>(request({"--help"})).find("render"), std::string::npos);
    const std::string help = std::get<std::string>(request({"render", "--help"}));
    for (const char* part : {"--size", "hunt-one: ", "spatial-median: "})
        EXPECT_NE(help.find(part), std::string::npos) << part;
    EXPECT_EQ(std::get<std::string>(request({"--version"})).find("cleave "), 0u);
    EXPECT_EQ(std::get<std::string>(request({"bench", "--version"})).find("cleave "), 0u);
}

TEST(Options, WrongUseNamesWhatThereIs) {
    for (const auto& wrong : std::vector<std::vector<const char*>>{{}, {"rendr"}, {"reports", "a.glb"}})
        expectRefused(wrong, "render, trace, query, info, bench, report, stability, devices");
    expectRefused({"render", "--builder", "nope"}, "gpu, gpu-exact, twin, exact");
    expectRefused({"render", "--builder", "havran"}, "gpu, gpu-exact, twin, exact");
    expectRefused({"render", "--builder", "gpu,exact"}, "gpu, gpu-exact, twin, exact");
    expectRefused({"bench", "a.glb", "--builder", "gpu,,exact"}, "''");
    expectRefused({"bench", "a.glb", "--builder", "gpu,gpu"}, "twice");
    expectRefused({"bench", "a.glb", "--survey", "--builder", "gpu"}, "--survey");
    expectRefused({"trace", "a.glb", "b.npy", "--traversal", "ropes"}, "restart");
    expectRefused({"render", "--view", "fog"}, "shaded, path, normals, depth, steps, leaves");
    expectRefused({"render", "--clip", "maybe"}, "on, off");
}

TEST(Options, Report) {
    const Options plain = parse({"report", "a.glb", "b c.glb"});
    EXPECT_EQ(plain.command, Command::report);
    EXPECT_EQ(plain.scenes.size(), 2u);
    EXPECT_EQ(plain.output, "report");
    EXPECT_EQ(plain.runs, 5u);
    EXPECT_EQ(plain.line, "cleave report a.glb 'b c.glb'") << "to be typed again";
    const Options quick = parse({"report", "it's.glb", "-o", "out", "--quick", "--peers"});
    EXPECT_EQ(quick.output, "out");
    EXPECT_EQ(quick.runs, 2u);
    EXPECT_TRUE(quick.peers);
    EXPECT_EQ(quick.line, R"(cleave report 'it'\''s.glb' -o out --quick --peers)");
    EXPECT_EQ(parse({"report", "a.glb", "--quick", "--runs", "7"}).runs, 7u);
    EXPECT_EQ(parse({"bench", "a.glb"}).runs, 5u);
    expectRefused({"report"}, "SCENE");
    expectRefused({"report", "a.glb", "./a.glb"}, "given twice");
}

TEST(Options, WaysOfRays) {
    const Options bench = parse({"bench", "a.glb", "--traversal", "stack,restart", "--triangle-test", "plain"});
    EXPECT_EQ(bench.traversals, (std::vector{Traversal::stack, Traversal::restart}));
    EXPECT_EQ(bench.triangleTests, std::vector{TriangleTest::plain});
    const Options trace = parse({"trace", "a.glb", "r.npy", "--triangle-test", "unfiltered"});
    EXPECT_TRUE(trace.traversals.empty()) << "the device's own";
    EXPECT_EQ(trace.triangleTests.front(), TriangleTest::unfiltered);
    expectRefused({"bench", "a.glb", "--traversal", "stack,stack"}, "given twice");
    expectRefused({"bench", "a.glb", "--traversal", "ropes"}, "restart, stack");
    expectRefused({"render", "--triangle-test", "watertight,plain"}, "watertight, plain, unfiltered");
}

TEST(Options, CostsOfTheHeuristic) {
    const Options given = parse({"info", "a.glb", "--cost-traverse", "1.5", "--cost-intersect", "8"});
    EXPECT_EQ(given.settings.costs.traverse, 1.5f);
    EXPECT_EQ(given.settings.costs.intersect, 8.0f);
    const Options none = parse({"info", "a.glb"});
    EXPECT_EQ(none.settings.costs.traverse, 15.0f);
    EXPECT_EQ(none.settings.costs.intersect, 20.0f);
    for (const char* wrong : {"0", "-1", "nan", "inf", "1e9", "x"})
        expectRefused({"info", "a.glb", "--cost-traverse", wrong}, "from 0.001 to 1000");
}

TEST(Options, RulesOfTheHeuristic) {
    const BuildSettings given = parse({"info", "a.glb", "--cost-leaf", "2.5", "--empty-bonus", "1", "--stop", "sa-n",
                                       "--snap", "off", "--other-axes", "off", "--small-nodes", "sort"})
                                    .settings;
    EXPECT_EQ(given.costs.leaf, 2.5f);
    EXPECT_EQ(given.costs.emptyBonus, 1.0f);
    EXPECT_EQ(given.stop, StopRule::equation41);
    EXPECT_FALSE(given.snap);
    EXPECT_FALSE(given.otherAxes);
    EXPECT_EQ(given.smallNodes, SmallNodes::sort);
    const BuildSettings none = parse({"info", "a.glb"}).settings;
    EXPECT_EQ(none.costs.leaf, 0.0f);
    EXPECT_EQ(none.costs.emptyBonus, 0.8f);
    EXPECT_EQ(none.stop, StopRule::cost);
    EXPECT_TRUE(none.snap);
    EXPECT_TRUE(none.otherAxes);
    EXPECT_EQ(none.smallNodes, SmallNodes::count);
    EXPECT_EQ(parse({"info", "a.glb", "--cost-leaf", "0"}).settings.costs.leaf, 0.0f);
    for (const char* wrong : {"-1", "1001", "nan", "x"})
        expectRefused({"info", "a.glb", "--cost-leaf", wrong}, "from 0 to 1000");
    for (const char* wrong : {"0", "1.01", "-0.5", "inf"})
        expectRefused({"render", "--empty-bonus", wrong}, "from 0.001 to 1");
    expectRefused({"render", "--stop", "never"}, "sah, sa-n");
    expectRefused({"render", "--snap", "1"}, "on, off");
    expectRefused({"render", "--other-axes", "all"}, "on, off");
    expectRefused({"render", "--small-nodes", "scan"}, "count, sort");
}

TEST(Options, Times) {
    EXPECT_FALSE(parse({"render"}).time || parse({"render"}).frames);
    for (const std::vector<const char*>& command : {std::vector<const char*>{"render", "a.glb"},
                                                    {"info", "a.glb"},
                                                    {"bench", "a.glb"},
                                                    {"trace", "a.glb", "r.npy"}}) {
        std::vector<const char*> arguments = command;
        arguments.insert(arguments.end(), {"--time", "-1.5", "--animation", "walk"});
        EXPECT_EQ(parse(arguments).time, -1.5);
        EXPECT_EQ(parse(arguments).animation, "walk");
    }
    for (const char* time : {"nan", "inf", "1s", ""}) expectRefused({"info", "a.glb", "--time", time}, "--time");
}

TEST(Options, Frames) {
    const FrameRange plain = parse({"render", "--fps", "23.976", "--frames", "3:3"}).frames.value();
    EXPECT_EQ(plain.first, 3u);
    EXPECT_EQ(plain.last, 3u);
    EXPECT_EQ(plain.fps, 23.976);
    EXPECT_EQ(plain.part, 0u);
    EXPECT_EQ(plain.parts, 1u);
    EXPECT_FALSE(plain.skipExisting);
    const FrameRange part =
        parse({"render", "--frames", "0:240", "--fps", "24", "--part", "2/3", "--skip-existing"}).frames.value();
    EXPECT_EQ(part.last, 240u);
    EXPECT_EQ(part.part, 2u);
    EXPECT_EQ(part.parts, 3u);
    EXPECT_TRUE(part.skipExisting);
    for (const char* range : {"3:2", "-1:2", "1", "1:", ":1", "1:2:3", "0:1e3", "1.0:2", " 1:2", "0:1000000000", "a:b"})
        expectRefused({"render", "--frames", range, "--fps", "1"}, "A not above B");
    for (const char* fps : {"0", "-1", "nan", "inf", "x"})
        expectRefused({"render", "--frames", "0:1", "--fps", fps}, "a number above 0");
    expectRefused({"render", "--frames", "0:1", "--fps", "1e-310"}, "no finite number");
    for (const char* one : {"2/2", "3/2", "0/0", "-1/2", "1", "1/", "/2", "a/b", "0.5/2"})
        expectRefused({"render", "--frames", "0:1", "--fps", "1", "--part", one}, "I from 0 to N - 1");
    expectRefused({"render", "--frames", "0:1"}, "--fps");
    for (const std::vector<const char*>& alone :
         {std::vector<const char*>{"--fps", "1"}, {"--part", "0/2"}, {"--skip-existing"}}) {
        std::vector<const char*> arguments{"render"};
        arguments.insert(arguments.end(), alone.begin(), alone.end());
        expectRefused(arguments, "--frames");
    }
    expectRefused({"render", "--frames", "0:1", "--fps", "1", "--time", "2"}, "--time");
    expectRefused({"info", "a.glb", "--frames", "0:1"}, "--frames");
    for (const char* json : {"d/f_0001.png", "d/../d/f_0000.png", "d/f_123456.png"})
        expectRefused({"render", "-o", "d/f.png", "--frames", "0:1", "--fps", "1", "--json", json},
                      "what a frame is called");
    for (const char* json : {"d/f_1.png", "f_0001.png", "d/f_0001.json", "d/f.png.json", "d/f_x.png"})
        EXPECT_EQ(refusal({"render", "-o", "d/f.png", "--frames", "0:1", "--fps", "1", "--json", json}), "") << json;
}

TEST(Options, DevicePoseIsAChoiceOfFrames) {
    EXPECT_EQ(parse({"render"}).devicePose, Choice::automatic);
    EXPECT_EQ(parse({"render", "--frames", "0:1", "--fps", "2", "--device-pose", "on"}).devicePose, Choice::on);
    EXPECT_EQ(parse({"render", "--frames", "0:1", "--fps", "2", "--device-pose", "off"}).devicePose, Choice::off);
    expectRefused({"render", "--frames", "0:1", "--fps", "2", "--device-pose", "maybe"}, "auto, on, off");
    expectRefused({"render", "--device-pose", "on"}, "--frames");
}

TEST(Options, SplitMovingIsAChoice) {
    EXPECT_EQ(parse({"render"}).splitMoving, Choice::automatic);
    EXPECT_EQ(parse({"render", "--split-moving", "off"}).splitMoving, Choice::off);
    EXPECT_EQ(parse({"trace", "a.glb", "r.npy", "--split-moving", "on"}).splitMoving, Choice::on);
    expectRefused({"render", "--split-moving", "maybe"}, "auto, on, off");
    expectRefused({"render", "--tree", "t", "--split-moving", "on"}, "--split-moving");
    for (const char* query : {"--count", "--all=3"})
        expectRefused({"trace", "a.glb", "r.npy", query, "--split-moving", "on"}, "one tree");
}

TEST(FrameFiles, HaveFourDigitsOrMore) {
    EXPECT_EQ(frameFile("f.png", 0), "f_0000.png");
    EXPECT_EQ(frameFile("a/b.c/f.x.exr", 42), "a/b.c/f.x_0042.exr");
    EXPECT_EQ(frameFile("f", 12345), "f_12345");
}

TEST(Options, OptionsOfLaterAreNotTakenYet) {
    for (const char* option : {"--shutter", "--aperture"}) {
        expectRefused({"render", option, "4"}, option);
        expectRefused({"render", option, "4"}, "--size");
    }
    expectRefused({"trace", "a.glb", "r.npy", "--some", "3"}, "--any");
    expectRefused({"info", "a.glb", "--check", "3"}, "--validate");
    expectRefused({"query", "a.glb", "p.npy", "--nearest", "--tree", "t", "--builder", "exact"}, "--tree");
    expectRefused({"render", "--tree", "t", "--frames", "0:1", "--fps", "1"}, "--tree");
    expectRefused({"render", "a.glb", "b.glb"}, "b.glb");
}

TEST(Options, BadValues) {
    for (const char* size :
         {"big", "0x10", "10x0", "10", "10x", "x10", "1e3x10", "-5x5", "20000x1", "16384x16384", "8x8x8"})
        expectRefused({"render", "--size", size}, "WIDTHxHEIGHT");
    for (const char* eye : {"1,2", "1,2,3,4", "a,b,c", "1,,3", "nan,0,0", "inf,0,0", "1,2,3 "})
        expectRefused({"render", "--eye", eye}, "x,y,z");
    for (const char* fov : {"0", "180", "-10", "nan", "wide"}) expectRefused({"render", "--fov", fov}, "angle");
    for (const char* memory : {"0", "lots", "1T", "-1", "M", "99999999999G", "1.5G"})
        expectRefused({"render", "--memory", memory}, "size");
    for (const char* count : {"0", "-1", "many", "1.5", ""})
        expectRefused({"render", "--check", count}, "whole number");
    expectRefused({"render", "--spp", "0"}, "from 1 to");
    expectRefused({"render", "--spp", "4", "--view", "depth"}, "shows one ray");
    expectRefused({"render", "--exposure", "nan"}, "from -64 to 64");
    expectRefused({"render", "--time-limit", "0"}, "above 0");
    expectRefused({"render", "--bounces", "5000"}, "from 0 to 4096");
    expectRefused({"render", "--bins", "1"}, "from 2 to 512");
    expectRefused({"render", "--bins", "513", "--builder", "shevtsov"}, "from 2 to 512");
    expectRefused({"render", "--bins", "33"}, "gpu and twin have at most 32");
    expectRefused({"bench", "a.glb", "--bins", "33", "--builder", "shevtsov,twin"}, "gpu and twin have at most 32");
    expectRefused({"stability", "--bins", "33"}, "gpu and twin have at most 32");
    expectRefused({"render", "--exact-up-to", "1025"}, "from 0 to 1024");
    expectRefused({"render", "--max-depth", "64"}, "from 1 to 63");
    expectRefused({"render", "--threads", "0"}, "from 1 to");
    expectRefused({"bench", "a.glb", "--runs", "0"}, "from 1 to");
    expectRefused({"render", "--size"}, "--size");
    expectRefused({"info"}, "SCENE");
    expectRefused({"bench"}, "SCENE");
    expectRefused({"trace", "a.glb"}, "RAYS");
    expectRefused({"render", "-o", "a", "--json", "./a"}, "same file");
}

TEST(OptionValues, Bytes) {
    EXPECT_EQ(parseBytes("1048576"), 1u << 20);
    EXPECT_EQ(parseBytes("64K"), 1u << 16);
    EXPECT_EQ(parseBytes("2G"), uint64_t{2} << 30);
    EXPECT_EQ(parseBytes("512MiB"), 512u << 20);
    EXPECT_EQ(parseBytes("512MB"), 512u << 20);
    EXPECT_EQ(parseBytes("17179869183G"), uint64_t{17179869183u} << 30);
    EXPECT_EQ(parseBytes("17179869184G"), std::nullopt) << "2^64 bytes do not fit";
}

}  // namespace
}  // namespace cleave::test
