// render --frames from outside, and --time: which files there are, and what they show.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "scene/moving_triangle.h"
#include "support/program.h"
#include "support/ray_file.h"

namespace cleave::test {
namespace {

namespace fs = std::filesystem;

std::string feature(const std::string& name) { return CLEAVE_SOURCE "/scenes/features/" + name + ".glb"; }

class Frames : public testing::Test {
  protected:
    std::string at(const std::string& name) const { return (folder_ / name).string(); }
    Json reportOf(const std::string& name) const { return Json::parse(contentOf(folder_ / name)); }
    std::string scene(const std::string& name, const Document& document) const {
        put(folder_ / name, document.text());
        return at(name);
    }
    static Outcome render(std::vector<std::string> arguments, const std::string& before = "") {
        arguments.insert(arguments.begin(), "render");
        if (std::find(arguments.begin(), arguments.end(), "--size") == arguments.end())
            arguments.insert(arguments.end(), {"--size", "48x36"});
        return runCleave(arguments, before);
    }
    // The picture of a scene, by further options.
    std::string picture(const std::string& file, const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{file, "-o", at("one.png"), "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = render(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return contentOf(folder_ / "one.png");
    }
    // Those of its frames 0 and 1, at 0 and 1 seconds.
    std::pair<std::string, std::string> twoFrames(const std::string& file, const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{file, "-o", at("two.png"), "--frames", "0:1", "--fps", "1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = render(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return {contentOf(folder_ / "two_0000.png"), contentOf(folder_ / "two_0001.png")};
    }

    TemporaryFolder folder_;
};

TEST_F(Frames, ShowWhatTheirTimeShows) {
    for (const char* name : {"animation", "morph_target", "skin"}) {
        const auto [first, second] = twoFrames(feature(name), {});
        EXPECT_TRUE(first.starts_with("\x89PNG")) << name;
        EXPECT_NE(first, second) << name;
        EXPECT_EQ(second, picture(feature(name), {"--time", "1"})) << name;
        EXPECT_EQ(second, picture(feature(name), {"--time", "1", "--animation", "0"})) << name;
    }
}

TEST_F(Frames, PartsAreTheWholeAndSkippedOnesStay) {
    const std::string skin = feature("skin");
    for (const char* folder : {"whole", "parts"}) fs::create_directory(folder_ / folder);
    const auto run = [&](const std::string& output, const std::vector<std::string>& more) {
        std::vector<std::string> arguments{skin, "-o", at(output), "--frames", "7:11", "--fps", "8", "--json", at("j")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = render(arguments);
        ASSERT_EQ(outcome.status, 0) << outcome.err;
    };
    run("whole/f.png", {});
    Json report = reportOf("j");
    ASSERT_EQ(report["frames"].size(), 5u);
    for (uint64_t i = 0; i < 5; ++i) {
        const Json& frame = report["frames"][i];
        EXPECT_EQ(frame["frame"], 7 + i);
        EXPECT_TRUE(fs::exists(std::string(frame["file"])));
        EXPECT_GT(frame["buildMs"], 0.0);
        EXPECT_GT(frame["traceMs"], 0.0);
        EXPECT_EQ(frame["movingTriangles"], 768);
        EXPECT_EQ(frame["staticTriangles"], 2);
    }
    run("parts/f.png", {"--part", "1/2"});
    EXPECT_EQ(reportOf("j")["frames"].size(), 2u);
    EXPECT_TRUE(fs::exists(folder_ / "parts/f_0008.png"));
    EXPECT_FALSE(fs::exists(folder_ / "parts/f_0007.png"));
    put(folder_ / "parts/f_0008.png", "finished");
    put(folder_ / "parts/f_0010.png", "");
    run("parts/f.png", {"--skip-existing"});
    report = reportOf("j");
    EXPECT_EQ(report["skippedFrames"], 1);
    EXPECT_EQ(report["frames"].size(), 4u) << "an empty file is no picture";
    EXPECT_EQ(contentOf(folder_ / "parts/f_0008.png"), "finished");
    run("parts/f.png", {"--part", "1/2"});
    for (const char* file : {"f_0007.png", "f_0008.png", "f_0009.png", "f_0010.png", "f_0011.png"}) {
        EXPECT_EQ(contentOf(folder_ / "whole" / file), contentOf(folder_ / "parts" / file)) << file;
        EXPECT_FALSE(contentOf(folder_ / "whole" / file).empty()) << file;
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "parts"), {}), 5) << "and nothing else";
    run("parts/f.png", {"--part", "8/9"});
    EXPECT_EQ(reportOf("j")["frames"], Json::array()) << "a part may have no frame";
}

// One triangle stays; the other, which is beside it at rest, flies off. The default camera, and with it what the
// picture shows of the one that stays, is the same; so are hits, whatever power of two scales the scene.
TEST_F(Frames, WhatStaysLooksTheSameWhileOthersFlyOff) {
    Document document = triangleDocument();
    document.json["nodes"].push_back({{"mesh", 0}});
    document.json["scenes"][0]["nodes"] = {0, 1};
    const std::string file =
        scene("fly.gltf", Animated(document).add("translation", "STEP", {0, 1}, {-100, 0, 0, -1e20f, 0, 0}).document());
    for (const char* view : {"shaded", "normals", "path"}) {
        const auto [near, far] = twoFrames(file, {"--view", view, "--bounces", "2"});
        EXPECT_EQ(near, far) << view;
        const auto none = scene("none.gltf", [&] {
            Document other = document;
            other.json["scenes"][0]["nodes"] = {0};
            return Animated(other).add("translation", "STEP", {0, 1}, {-100, 0, 0, -1e20f, 0, 0}).document();
        }());
        EXPECT_NE(near, twoFrames(none, {"--view", view, "--bounces", "2"}).first) << "the other one is seen: " << view;
    }
}

// A camera and a lamp on a node that moves from (0, 0, 2) to (0.5, 0, 3), beside the same node standing there.
TEST_F(Frames, CamerasAndLightsFollowTheirNodes) {
    Document document = triangleDocument();
    document.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.9}, {"znear", 0.1}}}}};
    document.json["extensionsUsed"] = {"KHR_lights_punctual"};
    document.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 30}}};
    Json light = {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}};
    Json camera = {{"camera", 0}};
    for (const char* what : {"camera", "light"}) {
        Json moving = what[0] == 'c' ? camera : light, standing = what[0] == 'c' ? light : camera;
        moving["translation"] = {0, 0, 2};
        standing["translation"] = {0.25, 0.25, 4};
        Document moves = document;
        moves.json["nodes"].insert(moves.json["nodes"].end(), {moving, standing});
        moves.json["scenes"][0]["nodes"] = {0, 1, 2};
        Document stands = moves;
        stands.node(1)["translation"] = {0.5, 0, 3};
        const std::string file =
            scene("m.gltf", Animated(moves).add("translation", "LINEAR", {0, 1}, {0, 0, 2, 0.5f, 0, 3}, 1).document());
        const std::vector<std::string> more{"--view", "path", "--spp", "2"};
        const auto [first, second] = twoFrames(file, more);
        EXPECT_NE(first, second) << what;
        EXPECT_EQ(first, picture(file, more)) << what << ": the rest pose is the first key";
        EXPECT_EQ(second, picture(scene("s.gltf", stands), more)) << what;
    }
}

// A folder has the name of the second frame, which therefore cannot be written.
TEST_F(Frames, AFrameThatFailsIsNamedAndLeavesTheOthers) {
    fs::create_directories(folder_ / "f_0001.png/taken");
    const Outcome outcome =
        render({feature("animation"), "-o", at("f.png"), "--frames", "0:3", "--fps", "1", "--json", at("j")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.errorLines(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("frame 1, at 1.000 s, failed"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("1 of 4 frames are done"), std::string::npos) << outcome.err;
    EXPECT_TRUE(contentOf(folder_ / "f_0000.png").starts_with("\x89PNG"));
    EXPECT_EQ(reportOf("j")["frames"].size(), 1u);
    std::vector<std::string> names = folder_.names();
    std::sort(names.begin(), names.end());
    EXPECT_EQ(names, (std::vector<std::string>{"f_0000.png", "f_0001.png", "j"}));
}

// The program is told to end when the third picture is there; the frame that it is at is finished, none is begun.
TEST_F(Frames, AnInterruptionEndsAfterAFrame) {
    const std::string interrupted = "f() { \"$@\" & while [ ! -e '" + at("f_0002.png") +
                                    "' ] && kill -0 $! 2>/dev/null; do sleep 0.02; done; kill -TERM $!; wait $!; }; f";
    const Outcome outcome =
        render({feature("animation"), "-o", at("f.png"), "--frames", "0:100000", "--fps", "1000", "--json", at("j")},
               interrupted);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.errorLines(), 1u) << outcome.err;
    EXPECT_NE(outcome.err.find("interrupted after frame "), std::string::npos) << outcome.err;
    const size_t done = reportOf("j")["frames"].size();
    EXPECT_GE(done, 3u);
    EXPECT_LT(done, 100000u);
    const std::vector<std::string> names = folder_.names();
    EXPECT_EQ(names.size(), done + 1) << "pictures and the report";
    for (const std::string& name : names)
        if (name != "j") {
            const std::string png = contentOf(folder_ / name);
            EXPECT_NE(png.find("IEND"), std::string::npos) << name;
        }
}

// Memory does not grow with frames: neither by a tree of 68,016 triangles, nor slowly. CLEAVE_LONG=1: a thousand
// frames.
TEST_F(Frames, LeaveNothingBehind) {
    const char* isLong = std::getenv("CLEAVE_LONG");
    const auto peakOf = [&](const std::string& file, uint64_t last) {
        const Outcome outcome = render({file, "-o", at("f.png"), "--frames", "0:" + std::to_string(last), "--fps", "50",
                                        "--size", "16x12", "--json", at("j")});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return reportOf("j")["process"]["peakBytes"].get<uint64_t>();
    };
    const uint64_t many = isLong && std::string(isLong) == "1" ? 999 : 59;
    for (const auto& [file, last] :
         {std::pair(std::string(CLEAVE_SOURCE "/scenes/still_life.glb"), uint64_t{9}), {feature("skin"), many}}) {
        const uint64_t few = peakOf(file, 1);
        EXPECT_LT(peakOf(file, last), few + (8u << 20)) << file;
    }
}

// A tree of its own for what moves changes no picture.
TEST_F(Frames, AreTheSameWithATreeForWhatMoves) {
    for (const auto& [name, view] : {std::pair("animation", "shaded"), {"morph_target", "path"}, {"skin", "depth"}}) {
        const auto frames = [&](const char* split) {
            return twoFrames(feature(name), {"--view", view, "--json", at("j"), "--split-moving", split});
        };
        const auto whole = frames("off");
        EXPECT_EQ(reportOf("j")["build"]["trees"], 1);
        EXPECT_EQ(reportOf("j")["build"]["staticMs"], 0.0);
        EXPECT_EQ(frames("on"), whole) << name << ", " << view;
        const Json report = reportOf("j");
        EXPECT_EQ(report["build"]["trees"], 2);
        EXPECT_GT(report["build"]["staticMs"], 0.0);
        EXPECT_GT(report["frames"][1]["buildMs"], 0.0);
    }
    ASSERT_EQ(render({feature("unlit"), "-o", at("f.png"), "--frames", "0:1", "--fps", "1", "--split-moving", "on",
                      "--json", at("j")})
                  .status,
              0);
    EXPECT_EQ(reportOf("j")["build"]["trees"], 1) << "nothing moves";
}

// From the second frame on only what moves is posed and uploaded; with views that show what corners have, too.
TEST_F(Frames, ShowWhatTheirTimeShowsAfterOthers) {
    for (const char* view : {"depth", "normals", "shaded", "path"})
        for (const char* name : {"animation", "morph_target", "skin"}) {
            ASSERT_EQ(render({feature(name), "-o", at("f.png"), "--frames", "1:4", "--fps", "3", "--view", view,
                              "--split-moving", "on", "--quiet"})
                          .status,
                      0);
            EXPECT_EQ(contentOf(folder_ / "f_0003.png"), picture(feature(name), {"--time", "1", "--view", view}))
                << name << ", " << view;
        }
}

// A sheet of 2 x 40 x 40 triangles between two joints, above a triangle that stays. Joint 2 goes up, and then so far
// that floats do not reach.
Document sheet() {
    constexpr uint16_t kSide = 40;
    Floats positions, weights;
    std::vector<uint8_t> joints;
    std::vector<uint16_t> indices;
    for (uint16_t y = 0; y <= kSide; ++y)
        for (uint16_t x = 0; x <= kSide; ++x) {
            const float u = float(x) / kSide, v = float(y) / kSide;
            positions.insert(positions.end(), {u, 0.1f * std::sin(7 * u), v});
            weights.insert(weights.end(), {1 - u, 0.7f * u, 0, 0});
            joints.insert(joints.end(), {0, 1, 0, 0});
            const auto i = static_cast<uint16_t>(y * (kSide + 1) + x), below = static_cast<uint16_t>(i + kSide + 1);
            if (x == kSide || y == kSide) continue;
            for (const int index : {int{i}, int{below}, i + 1, i + 1, int{below}, below + 1})
                indices.push_back(static_cast<uint16_t>(index));
        }
    Document document;
    document.addMesh(document.addPositions(positions), document.addIndices(indices));
    document.addMesh(document.addPositions({-1, -1, -1, 2, -1, -1, 0, -1, 3}));
    const size_t count = positions.size() / 3;
    document.primitive()["attributes"]["JOINTS_0"] =
        document.addAccessor(document.addView(bytesOf(joints)), 5121, count, "VEC4");
    document.primitive()["attributes"]["WEIGHTS_0"] =
        document.addAccessor(document.addView(bytesOf(weights)), 5126, count, "VEC4");
    document.json["skins"] = {{{"joints", {2, 3}}}};
    document.node()["skin"] = 0;
    document.json["nodes"].push_back(Json::object());
    document.json["nodes"].push_back({{"scale", {1e-30, 1e-30, 1e-30}}});
    document.json["nodes"].push_back({{"scale", {1e30, 1e30, 1e30}}, {"children", {3}}});
    document.json["scenes"][0]["nodes"] = {1, 0, 2, 4};
    const Floats places{0, 0, 0, 0, 4e-31f, 0, 0, 1e20f, 0, 2e-31f, 0, 0, 0, 1e-30f, 0};
    return Animated(document).add("translation", "STEP", {0, 1, 2, 3, 4}, places, 3).document();
}

// Nobody sees whether the device poses: not in pictures, nor in what is judged or warned of.
TEST_F(Frames, AreTheSameWhereTheDevicePoses) {
    const std::string file = scene("sheet.gltf", sheet());
    for (const char* view : {"depth", "shaded"}) {
        const std::vector<std::string> looks{"--eye", "2,2,3", "--look", "0.5,0,0.5", "--view", view};
        std::vector<std::string> alone;
        for (const char* second : {"0", "1", "2", "3", "4"}) {
            std::vector<std::string> arguments{"--time", second};
            arguments.insert(arguments.end(), looks.begin(), looks.end());
            alone.push_back(picture(file, arguments));
        }
        EXPECT_NE(alone[1], alone[3]);
        for (const char* split : {"on", "off"}) {
            std::vector<std::string> arguments{file,    "-o",      at("f.png"),     "--frames", "0:4",
                                               "--fps", "1",       "--device-pose", "on",       "--split-moving",
                                               split,   "--check", "300",           "--json",   at("j")};
            arguments.insert(arguments.end(), looks.begin(), looks.end());
            const Outcome outcome = render(arguments);
            ASSERT_EQ(outcome.status, 0) << outcome.err;
            EXPECT_NE(outcome.err.find("triangles have a vertex that is not finite, the first is number 1"),
                      std::string::npos)
                << outcome.err;
            const Json frames = reportOf("j")["frames"];
            for (size_t i = 0; i < 5; ++i) {
                EXPECT_EQ(frames[i]["posedBy"], view == std::string("depth") && i > 0 ? "device" : "host");
                EXPECT_EQ(frames[i]["check"]["mismatches"], 0);
                EXPECT_EQ(contentOf(folder_ / ("f_000" + std::to_string(i) + ".png")), alone[i])
                    << view << ", frame " << i << ", split " << split;
            }
        }
    }
}

// A target whose data is nowhere leaves its primitive out as long as it has a weight. What it leaves, and whose numbers
// are others then, is seen all the same.
TEST_F(Frames, FollowWhatTheFileLacksAtTheirTime) {
    Document document = morphDocument();
    const int nowhere = document.addPositions({0, 0, 1, 0, 0, 1, 0, 0, 1});
    document.primitive()["targets"][1]["POSITION"] = nowhere;
    const int turned = document.addPositions({0, 0, 0, 2, 0, 0, 0, 0, 2});
    document.addMesh(turned);
    document.addMesh(turned);
    document.json["nodes"][2]["translation"] = {0, -1, 0};
    document.json["scenes"][0]["nodes"] = {0, 1, 2};
    Animated animated = Animated(document).add("weights", "STEP", {0, 1, 2}, {0.5f, 0, 0.5f, 1, 0.25f, 0});
    animated.add("translation", "LINEAR", {0, 3}, {0, 0, 0, 0, 1, 1}, 1);
    Json& json = animated.document().json;
    const std::string& data = animated.document().data;
    json["buffers"] = {{{"byteLength", data.size()}, {"uri", "data:application/octet-stream;base64," + base64(data)}},
                       {{"byteLength", data.size()}}};
    json["bufferViews"][size_t(json["accessors"][size_t(nowhere)]["bufferView"])]["buffer"] = 1;
    const std::string file = scene("lacking.gltf", animated.document());
    for (const char* view : {"depth", "shaded"}) {
        const Outcome outcome = render({file, "-o", at("f.png"), "--frames", "0:2", "--fps", "1", "--view", view,
                                        "--split-moving", "on", "--json", at("j"), "--check", "200"});
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_NE(outcome.err.find("is left out"), std::string::npos) << outcome.err;
        EXPECT_EQ(reportOf("j")["frames"][0]["movingTriangles"], 2);
        EXPECT_EQ(reportOf("j")["frames"][1]["movingTriangles"], 1);
        EXPECT_EQ(reportOf("j")["frames"][2]["movingTriangles"], 2);
        for (const char* second : {"0", "1", "2"})
            EXPECT_EQ(contentOf(folder_ / (std::string("f_000") + second + ".png")),
                      picture(file, {"--time", second, "--view", view}))
                << view << " at " << second;
    }
}

// By itself where building counts for more than rays: a picture of a few pixels, not one of many.
TEST_F(Frames, HaveATreeForWhatMovesWhereThatPays) {
    for (const auto& [size, trees] : {std::pair("8x6", 2), {"128x96", 1}}) {
        ASSERT_EQ(render({feature("animation"), "-o", at("f.png"), "--frames", "0:1", "--fps", "1", "--size", size,
                          "--view", "depth", "--json", at("j")})
                      .status,
                  0);
        EXPECT_EQ(reportOf("j")["build"]["trees"], trees) << size;
    }
}

TEST_F(Frames, HitsAreTheSameWithATreeForWhatMoves) {
    put(folder_ / "rays.npy", rayFile({{{-3.0f, 0.4f, 0.1f}, 0.0f, {1.0f, 0.0f, 0.01f}, infinity()},
                                       {{0.0f, 3.0f, 0.0f}, 0.0f, {0.1f, -1.0f, 0.0f}, infinity()}}));
    for (const char* query : {"", "--any"}) {
        std::set<std::string> answers;
        for (const char* split : {"on", "off", "auto"}) {
            std::vector<std::string> arguments{
                "trace",     feature("animation"), at("rays.npy"), "--time", "0.5",   "-o",
                at("h.npy"), "--split-moving",     split,          "--json", at("j"), "--check",
                "2"};
            if (*query) arguments.emplace_back(query);
            ASSERT_EQ(runCleave(arguments).status, 0);
            answers.insert(contentOf(folder_ / "h.npy"));
            const Json build = reportOf("j")["build"];
            EXPECT_EQ(build["trees"], split == std::string("on") ? 2 : 1);
            EXPECT_GT(build["nodes"], 0);
            if (build["trees"] == 2) {
                EXPECT_FALSE(build["parts"][0]["moves"]);
                EXPECT_TRUE(build["parts"][1]["moves"]);
            }
        }
        if (*query == '\0') {
            EXPECT_EQ(answers.size(), 1u);  // which triangle --any finds is left open
        }
    }
}

TEST_F(Frames, OfASceneWithoutAnimationAreAllTheSame) {
    const Outcome outcome =
        render({feature("unlit"), "-o", at("f.png"), "--frames", "9999:10000", "--fps", "1", "--json", at("j")});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.err.find("has no animation"), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(contentOf(folder_ / "f_9999.png"), contentOf(folder_ / "f_10000.png"));
    EXPECT_NE(outcome.out.find("2 rendered: " + at("f_9999.png") + " to " + at("f_10000.png")), std::string::npos)
        << outcome.out;
    EXPECT_EQ(reportOf("j")["frames"][0]["movingTriangles"], 0);
}

TEST_F(Frames, AreJudgedOneByOne) {
    const Outcome outcome = render({feature("skin"), "-o", at("f.exr"), "--frames", "0:1", "--fps", "1", "--check",
                                    "500", "--builder", "exact", "--json", at("j")});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(fs::exists(folder_ / "f_0001.exr"));
    const Json report = reportOf("j");
    EXPECT_EQ(report["check"]["rays"], 1000);
    EXPECT_EQ(report["check"]["mismatches"], 0);
    EXPECT_EQ(report["frames"][1]["check"]["rays"], 500);
}

TEST_F(Frames, AnotherTimeIsAnotherSceneForEveryCommand) {
    std::set<std::string> hashes;
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{}, {"--time", "0.5"}, {"--time", "1.25", "--animation", "all"}}) {
        std::vector<std::string> arguments{"info", feature("skin"), "--builder", "exact", "--quiet", "--json", at("j")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        ASSERT_EQ(runCleave(arguments).status, 0);
        const Json report = reportOf("j");
        EXPECT_EQ(report["scene"]["triangles"], 770);
        hashes.insert(report["build"]["treeHash"]);
    }
    EXPECT_EQ(hashes.size(), 3u);
}

TEST_F(Frames, AnUnknownAnimationIsWrongUse) {
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"render", "--frames", "0:1", "--fps", "1", "-o", at("f.png")},
          {"info", "--time", "1"},
          {"bench", "--time", "1"}}) {
        std::vector<std::string> arguments = command;
        arguments.insert(arguments.begin() + 1, feature("skin"));
        arguments.insert(arguments.end(), {"--animation", "nope"});
        const Outcome outcome = runCleave(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_NE(outcome.err.find("0 'wave'"), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(folder_.names(), std::vector<std::string>{});
}

}  // namespace
}  // namespace cleave::test
