// The command line, parsed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/needs.h"
#include "figures/names.h"
#include "render/cmd_render.h"
#include "tree/kd_tree.h"

namespace cleave {

enum class Command { render, trace, query, info, bench, report, stability, devices };

// What the command query asks.
enum class Question { none, nearest, contains, overlaps };

// Of a way to do something that pays for some scenes.
enum class Choice { automatic, on, off };

// Frames of an animation: `first` to `last`, frame n at the time n / fps. Of these, those with (n - first) mod parts ==
// part.
struct FrameRange {
    uint64_t first = 0;
    uint64_t last = 0;
    double fps = 0.0;
    uint64_t part = 0;
    uint64_t parts = 1;
    bool skipExisting = false;
};

// What --animation says for all of them.
inline constexpr std::string_view kAllAnimations = "all";

struct Options {
    Command command = Command::devices;         // of cleave
    std::string line;                           // as it was typed, for figures to say where they come from
    std::vector<std::filesystem::path> scenes;  // render: may be empty, for the default scene; bench: several
    std::filesystem::path rays;                 // or points, or boxes
    std::filesystem::path output;               // out.png, hits.npy or the folder of a report
    std::optional<std::filesystem::path> json;
    bool quiet = false;

    std::vector<Builder> builders{Builder::gpu};  // bench: several; stability: empty means all
    bool namesBuilder = false;                    // on the command line
    BuildSettings settings;
    std::optional<std::filesystem::path> tree;      // a saved one, instead of building
    std::optional<std::filesystem::path> saveTree;  // info: where to keep what was built
    Choice instances = Choice::automatic;           // one tree for a mesh that stands in many places
    Choice lazy = Choice::automatic;                // build what rays come to
    NeedSet keep;                                   // not left out, though nothing needs it
    std::string device;
    uint64_t check = 0;  // rays of a run to be judged
    bool validate = false;

    std::optional<double> time;  // seconds; none: the rest pose
    std::string animation;       // by name or index, or kAllAnimations; empty: the first
    std::optional<FrameRange> frames;
    Choice splitMoving = Choice::automatic;  // a tree of its own for what moves
    Choice devicePose = Choice::automatic;   // of frames: what moves is posed on the device

    uint32_t width = 1280;
    uint32_t height = 720;
    View view = View::shaded;
    std::optional<uint32_t> samples;  // of a pixel; the view's own number otherwise
    uint32_t bounces = 8;
    float exposure = 1.0f;            // a factor on radiance
    std::optional<double> timeLimit;  // seconds of rendering
    std::string camera;               // by name or index
    std::optional<glm::dvec3> eye;
    std::optional<glm::dvec3> look;
    std::optional<double> fov;  // vertical, degrees

    Query query = Query::closest;
    uint32_t hitsPerRay = 1;  // of Query::all
    Question question = Question::none;
    float within = std::numeric_limits<float>::infinity();  // the farthest that a nearest point may be
    std::vector<Traversal> traversals;  // empty: the device's own; bench: several, all with each of the tests
    std::vector<TriangleTest> triangleTests{TriangleTest::watertight};
    uint32_t runs = 5;
    bool interior = false;
    bool work = false;     // bench: what rays do on their way, too
    bool peers = false;    // bench, report: other ray tracers too, on the same rays
    bool queries = false;  // bench: the other queries instead of closest and any hits
    bool needs = false;    // bench: what leaving out saves, instead
    bool survey = false;   // bench: the survey's builders and tables instead of `builders`

    bool quick = false;
    std::vector<std::string> cases;  // of stability, by name; empty: all
    uint64_t rayCount = 0;           // per case and family of rays; 0: as many as fit the time
    uint64_t seed = 1;
    std::optional<uint64_t> parity;  // count so many lines through closed meshes instead
    std::optional<uint64_t> leaks;   // shoot so many rays from inside of closed meshes instead

    std::optional<std::filesystem::path> script;  // that drives the window
};

// A text to print instead of a run: help or version.
using Request = std::variant<Options, std::string>;

// What a pixel has without --spp: 64 samples for paths, 1 for others.
uint32_t defaultSamples(View view);
// Of --spp, or these.
uint32_t samplesOf(const Options& options);

// Rays per set that a benchmark judges before it tells any time: those of --check, or 2048.
uint64_t raysToJudge(const Options& options);

// Why a run cannot do without copies of meshes, whatever the scene; nothing if it can.
std::optional<std::string> needForCopies(const Options& options);

// Why a run needs the whole tree, whatever the scene; nothing if it can do with what rays come to.
std::optional<std::string> needForWholeTree(const Options& options);

// Wrong use of the command line: exit status 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Throws UsageError, whose text says what there is to choose from. Files are not looked at.
Request parseCommandLine(int argc, const char* const* argv);
// The command line of cleave-view.
Request parseViewerLine(int argc, const char* const* argv);

}  // namespace cleave
