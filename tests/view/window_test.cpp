// The real window, driven by scripts, on a display of its own (Xvfb). What it shows is compared with what `cleave
// render` writes: the same bytes.
#include <gtest/gtest.h>

#include <stb/stb_image.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <memory>

#include "support/program.h"

namespace cleave::test {
namespace {

const std::string kScenes = CLEAVE_SOURCE "/scenes/";

// Validation is on, and a message fails the test.
Outcome runWindow(const std::string& script, std::vector<std::string> arguments,
                  const std::string& before = "CLEAVE_VALIDATION=1") {
    const TemporaryFolder folder;
    put(folder / "script.txt", script);
    arguments.insert(arguments.end(), {"--script", (folder / "script.txt").string()});
    const Outcome outcome = runProgramAt(CLEAVE_VIEWER, arguments, before);
    EXPECT_EQ(outcome.err.find("validation:"), std::string::npos) << outcome.err;
    return outcome;
}

std::string rendered(std::vector<std::string> arguments) {
    const TemporaryFolder folder;
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"-o", (folder / "out.png").string(), "--quiet"});
    const Outcome outcome = runCleave(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return contentOf(folder / "out.png");
}

// A display that nobody sees, for as long as this lives; DISPLAY names it.
class HiddenDisplay {
  public:
    HiddenDisplay() {
        int numbers[2];
        if (pipe(numbers) != 0) std::abort();
        server_ = fork();
        if (server_ == 0) {
            close(numbers[0]);
            const std::string out = std::to_string(numbers[1]);
            execlp("Xvfb", "Xvfb", "-displayfd", out.c_str(), "-screen", "0", "1280x1024x24", "-nolisten", "tcp",
                   "-noreset", nullptr);
            _exit(127);
        }
        close(numbers[1]);
        std::string number;
        for (char c = 0; read(numbers[0], &c, 1) == 1 && c != '\n';) number += c;
        close(numbers[0]);
        if (!number.empty()) setenv("DISPLAY", (":" + number).c_str(), 1);
        isThere_ = !number.empty();
    }
    ~HiddenDisplay() {
        kill(server_, SIGTERM);
        waitpid(server_, nullptr, 0);
    }
    HiddenDisplay(const HiddenDisplay&) = delete;
    HiddenDisplay& operator=(const HiddenDisplay&) = delete;
    bool isThere() const { return isThere_; }

  private:
    pid_t server_ = -1;
    bool isThere_ = false;
};

class InWindow : public testing::Test {
  protected:
    static void SetUpTestSuite() { display_ = std::make_unique<HiddenDisplay>(); }
    static void TearDownTestSuite() { display_.reset(); }
    void SetUp() override {
        if (!display_->isThere()) GTEST_SKIP() << "Xvfb is not installed";
    }
    TemporaryFolder folder;
    std::string shot(const std::string& name) const { return "screenshot " + (folder / name).string() + "\n"; }
    std::string taken(const std::string& name) const { return contentOf(folder / name); }

  private:
    inline static std::unique_ptr<HiddenDisplay> display_;
};

TEST_F(InWindow, ShowsEveryViewAsRenderDoes) {
    const std::string scene = kScenes + "cornell.glb";
    std::string script = "size 200 120\n";
    const std::vector<std::string> views{"shaded", "normals", "depth", "steps", "leaves", "path"};
    for (const std::string& view : views) script += "view " + view + "\nwait idle\n" + shot(view + ".png");
    const Outcome outcome = runWindow(script, {scene, "--spp", "4"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    for (const std::string& view : views) {
        std::vector<std::string> arguments{scene, "--size", "200x120", "--view", view};
        if (view == "shaded" || view == "normals" || view == "path") arguments.insert(arguments.end(), {"--spp", "4"});
        EXPECT_TRUE(taken(view + ".png") == rendered(arguments)) << view;
    }
}

TEST_F(InWindow, TakesSizesCamerasAndBuilders) {
    const std::string scene = kScenes + "still_life.glb";
    const Outcome outcome = runWindow("size 160 100\nwait idle\n" + shot("a.png") +
                                          "size 90 130\neye 3 2 4\nlook 0.5 0 0\nbuilder shevtsov\n"
                                          "traversal restart\nwait idle\n" +
                                          shot("b.png") + "overlay 4\npanels on\nwait idle\n" + shot("c.png"),
                                      {scene});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(taken("a.png") == rendered({scene, "--size", "160x100"}));
    EXPECT_TRUE(taken("b.png") == rendered({scene, "--size", "90x130", "--eye", "3,2,4", "--look", "0.5,0,0"}));
    EXPECT_FALSE(taken("c.png").empty());
    EXPECT_FALSE(taken("c.png") == taken("b.png")) << "panel and cells are seen";
}

// The command that C copies, and prints, makes the picture that is shown.
TEST_F(InWindow, CopiesTheCommandOfWhatItShows) {
    const std::string scene = kScenes + "cornell.glb";
    const Outcome outcome = runWindow(
        "size 160 100\nwait idle\ndrag left 40 40 70 52\ndrag right 10 10 17 22\n"
        "scroll 2\nkey c\nwait idle\n" +
            shot("a.png"),
        {scene, "--view", "normals"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string command = "cleave render " + scene + " --size 160x100 --view normals --eye ";
    ASSERT_EQ(outcome.out.substr(0, command.size()), command);
    const std::string file = (folder / "b.png").string();
    const std::string again =
        quoted(CLEAVE_PROGRAM) + outcome.out.substr(6, outcome.out.find('\n') - 6) + " -o " + quoted(file) + " --quiet";
    EXPECT_EQ(std::system(again.c_str()), 0);
    EXPECT_TRUE(taken("a.png") == taken("b.png"));
}

TEST_F(InWindow, DoubleClickTurnsAboutWhatIsThere) {
    put(folder / "scene.gltf", triangleScene());  // in the plane z = 0
    const Outcome outcome =
        runWindow("size 160 100\nwait idle\ndoubleclick 80 50\nwait idle\nkey c\n", {(folder / "scene.gltf").string()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    double x = 9.0, y = 9.0, z = 9.0;
    const size_t at = outcome.out.find("--look ");
    ASSERT_NE(at, std::string::npos) << outcome.out;
    ASSERT_EQ(std::sscanf(outcome.out.c_str() + at, "--look %lf,%lf,%lf", &x, &y, &z), 3);
    EXPECT_NEAR(x, 0.0, 1e-6);
    EXPECT_NEAR(y, 0.0, 1e-6);
    EXPECT_NEAR(z, 0.0, 1e-6);
}

TEST_F(InWindow, ShowsAnAnimationAtATime) {
    const std::string scene = kScenes + "features/skin.glb";
    const Outcome outcome = runWindow("size 120 90\nwait idle\nplay\nwait frames 10\npause\ntime 0.5\nwait idle\n" +
                                          shot("a.png") + "time 1\nwait idle\n" + shot("b.png"),
                                      {scene});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(taken("a.png") == rendered({scene, "--size", "120x90", "--time", "0.5"}));
    EXPECT_TRUE(taken("b.png") == rendered({scene, "--size", "120x90", "--time", "1"}));
    EXPECT_FALSE(taken("a.png") == taken("b.png"));
}

TEST_F(InWindow, OpensWhatIsDroppedAndKeepsTheSceneIfThatIsBad) {
    put(folder / "bad.glb", "glTF or not");
    const std::string first = kScenes + "cornell.glb", second = kScenes + "shells.glb";
    const Outcome outcome =
        runWindow("size 120 90\nwait idle\ndrop " + (folder / "bad.glb").string() + "\nexpect error\nwait idle\n" +
                      shot("a.png") + "drop " + second + "\nwait idle\n" + shot("b.png"),
                  {first});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(taken("a.png") == rendered({first, "--size", "120x90"}));
    EXPECT_TRUE(taken("b.png") == rendered({second, "--size", "120x90"}));
}

// Our answers on the left and the reference's on the right are the same picture, and no pixel of it is red.
TEST_F(InWindow, ComparesWithTheReference) {
    const Outcome outcome = runWindow("size 160 120\nkey x\nwait idle\n" + shot("a.png"), {kScenes + "shells.glb"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load((folder / "a.png").c_str(), &width, &height, &channels, 4), stbi_image_free);
    ASSERT_TRUE(pixels && width == 160 && height == 120);
    size_t seen = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width / 2; ++x) {
            const stbi_uc* ours = pixels.get() + 4 * (y * width + x);
            const stbi_uc* theirs = ours + 4 * (width / 2);
            EXPECT_TRUE(std::equal(ours, ours + 4, theirs)) << x << ", " << y;
            EXPECT_LE(ours[0], ours[2]) << "blue, not red";
            seen += ours[2] > 0x40 ? 1 : 0;
        }
    }
    EXPECT_GT(seen, 500u) << "triangles";
}

// Memory of the process after so many rounds of use: drags, views, builders, scenes, sizes, an animation.
uint64_t bytesAfter(int rounds, const std::filesystem::path& json) {
    std::string script = "size 320 180\nwait idle\n";
    for (int i = 0; i < rounds; ++i)
        script +=
            "drag left 100 100 180 90\nview normals\nwait idle\nbuilder shevtsov\nview path\nwait frames 20\n"
            "view shaded\nbuilder gpu\nsize 300 200\nwait idle\ndrop " +
            kScenes + "features/skin.glb\nplay\nwait frames 20\npause\nkey t\nwait frames 3\nkey t\ndrop " + kScenes +
            "shells.glb\nsize 320 180\nwait idle\n";
    const Outcome outcome = runWindow(script, {kScenes + "shells.glb", "--json", json.string()}, "");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::string told = contentOf(json);
    const size_t at = told.find("\"residentBytes\": ");
    return at == std::string::npos ? 0 : std::strtoull(told.c_str() + at + 17, nullptr, 10);
}

TEST_F(InWindow, DoesNotGrowWithUse) {
    const bool isLong = std::getenv("CLEAVE_LONG") != nullptr;  // then some ten minutes
    const int rounds = isLong ? 375 : 10;
    const uint64_t before = bytesAfter(3, folder / "a.json"), after = bytesAfter(rounds, folder / "b.json");
    std::printf("%.1f MiB after 3 rounds, %.1f MiB after %d\n", static_cast<double>(before) / (1 << 20),
                static_cast<double>(after) / (1 << 20), rounds);
    ASSERT_GT(before, 0u);
    EXPECT_LT(after, before + (uint64_t{48} << 20));
}

TEST_F(InWindow, AStepThatFailsEndsItWithItsLine) {
    const std::string scene = kScenes + "triangle.gltf";
    const auto failure = [&](const std::string& script) {
        const Outcome outcome = runWindow(script, {scene});
        EXPECT_EQ(outcome.status, 1) << script;
        EXPECT_EQ(outcome.errorLines(), 1u) << outcome.err;
        return outcome.err;
    };
    EXPECT_NE(failure("wait idle\nview dreams\n").find("line 2: 'dreams' is not known; there is: shaded"),
              std::string::npos);
    EXPECT_NE(failure("wait idle\nscreenshot /nowhere/a.png\n").find("line 2: "), std::string::npos);
    EXPECT_NE(failure("expect error\n").find("line 1: an error was expected"), std::string::npos);
    EXPECT_NE(failure("drop /nowhere.glb\nwait idle\nquit\n").find("line 3: there was an error"), std::string::npos);
    EXPECT_NE(failure("fly 3\n").find("line 1: 'fly' is no step"), std::string::npos);
}

TEST_F(InWindow, SaysInOneLineWhatKeepsItFromOpening) {
    const Outcome none = runWindow("wait idle\n", {"/nowhere/scene.glb"});
    EXPECT_EQ(none.status, 1);
    EXPECT_EQ(none.errorLines(), 1u) << none.err;
    const Outcome blind = runProgramAt(CLEAVE_VIEWER, {kScenes + "triangle.gltf"}, "env -u DISPLAY -u WAYLAND_DISPLAY");
    EXPECT_EQ(blind.status, 1);
    EXPECT_EQ(blind.errorLines(), 1u) << blind.err;
    EXPECT_NE(blind.err.find("cannot open a window"), std::string::npos) << blind.err;
    const Outcome device = runWindow("wait idle\n", {kScenes + "triangle.gltf", "--device", "abacus"});
    EXPECT_EQ(device.status, 1);
    EXPECT_NE(device.err.find("no device is called 'abacus'"), std::string::npos) << device.err;
    EXPECT_EQ(runProgramAt(CLEAVE_VIEWER, {"--frames", "1:2"}, "").status, 2);
    EXPECT_EQ(runProgramAt(CLEAVE_VIEWER, {"--version"}, "").out.substr(0, 12), "cleave-view ");
}

}  // namespace
}  // namespace cleave::test
